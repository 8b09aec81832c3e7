#pragma once

#include <array>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace hachure::geometry {

/// An order of a graph's vertices in which a system with entries along its edges fills up little (approximate minimum
/// degree). Returns the place of every vertex in that order.
[[nodiscard]] std::vector<std::uint32_t> elimination_order(std::size_t vertices,
                                                           std::span<const std::array<std::uint32_t, 2>> edges);

/// Symmetric positive definite linear equations with `block` unknowns per vertex of a graph, solved by factorisation
/// (LDL^T), which gives the same bits on every run.
class SparseSystem {
public:
    /// `order` as of `elimination_order`.
    SparseSystem(std::span<const std::uint32_t> order, std::size_t block);
    ~SparseSystem();
    SparseSystem(SparseSystem&&) noexcept;
    SparseSystem& operator=(SparseSystem&&) noexcept;

    /// Adds to the entry between unknown `a` (block * vertex + component) and unknown `b`, and to its mirror image.
    /// Entries off the diagonal are given once.
    void add(std::size_t a, std::size_t b, double value);

    /// After the last entry. False when the matrix is not positive definite; there is nothing to solve then.
    [[nodiscard]] bool factorise();

    /// `right` and `x` hold block * vertices numbers and may be the same.
    void solve(std::span<const double> right, std::span<double> x) const;

private:
    struct Factors;
    std::unique_ptr<Factors> factors_;
};

/// The same for complex unknowns, one per vertex, and a Hermitian matrix: half the work of two real ones.
class HermitianSystem {
public:
    explicit HermitianSystem(std::span<const std::uint32_t> order);
    ~HermitianSystem();
    HermitianSystem(HermitianSystem&&) noexcept;
    HermitianSystem& operator=(HermitianSystem&&) noexcept;

    /// Adds to the entry in row `a` and column `b`, and the conjugate to its mirror image.
    void add(std::size_t a, std::size_t b, std::complex<double> value);
    [[nodiscard]] bool factorise();
    void solve(std::span<const std::complex<double>> right, std::span<std::complex<double>> x) const;

private:
    struct Factors;
    std::unique_ptr<Factors> factors_;
};

} // namespace hachure::geometry
