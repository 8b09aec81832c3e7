#pragma once

#include <hachure/runtime/geometry/sparse_system.h>

#include <complex>
#include <cstddef>

/// Energies of differences along edges, added to the matrix of their normal equations.
namespace hachure::geometry {

/// weight * (x_b - x_a)^2, one unknown per vertex.
inline void add_difference(SparseSystem& system, std::size_t a, std::size_t b, double weight) {
    system.add(a, a, weight);
    system.add(b, b, weight);
    system.add(a, b, -weight);
}

/// weight * |z_b - turn z_a|^2 for complex unknowns, two numbers per vertex; |turn| = 1. With `mirrored` it is
/// weight * |conj(z_b) - turn z_a|^2.
inline void add_turned_difference(SparseSystem& system, std::size_t a, std::size_t b, double weight,
                                  std::complex<double> turn, bool mirrored = false) {
    const double sign = mirrored ? -1.0 : 1.0, c = weight * turn.real(), s = weight * turn.imag();
    for (std::size_t k = 0; k < 2; ++k) {
        system.add(2 * a + k, 2 * a + k, weight);
        system.add(2 * b + k, 2 * b + k, weight);
    }
    system.add(2 * b, 2 * a, -c);
    system.add(2 * b, 2 * a + 1, s);
    system.add(2 * b + 1, 2 * a, -sign * s);
    system.add(2 * b + 1, 2 * a + 1, -sign * c);
}

/// weight * |z_b - turn z_a|^2 for complex unknowns; |turn| = 1.
inline void add_turned_difference(HermitianSystem& system, std::size_t a, std::size_t b, double weight,
                                  std::complex<double> turn) {
    system.add(a, a, weight);
    system.add(b, b, weight);
    system.add(b, a, -weight * turn);
}

} // namespace hachure::geometry
