#include <hachure/runtime/geometry/orientation.h>

#include <glm/vec3.hpp>

#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace hachure::geometry {
namespace {

/// A sum of doubles without rounding, as non-overlapping terms of rising magnitude (Shewchuk 1997, GROW-EXPANSION).
class ExactSum {
public:
    void add(double value) {
        std::size_t kept = 0;
        for (std::size_t i = 0; i < count_; ++i) {
            const double sum = value + terms_[i], part = sum - value;
            const double rest = (value - (sum - part)) + (terms_[i] - part);
            if (rest != 0.0) terms_[kept++] = rest;
            value = sum;
        }
        terms_[kept++] = value;
        count_ = kept;
    }
    [[nodiscard]] int sign() const {
        const double largest = count_ == 0 ? 0.0 : terms_[count_ - 1];
        return (largest > 0.0) - (largest < 0.0);
    }

private:
    double terms_[64];
    std::size_t count_ = 0;
};

/// Adds x * y * z. The product of two floats fits a double, and each half of it times the third does again.
void add_product(ExactSum& sum, float x, float y, float z) {
    const double product = static_cast<double>(x) * static_cast<double>(y);
    const double high = std::bit_cast<double>(std::bit_cast<std::uint64_t>(product) & ~std::uint64_t{0x3ffffff});
    sum.add(high * static_cast<double>(z));
    sum.add((product - high) * static_cast<double>(z));
}

void add_determinant(ExactSum& sum, const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
    add_product(sum, a.x, b.y, c.z);
    add_product(sum, a.y, b.z, c.x);
    add_product(sum, a.z, b.x, c.y);
    add_product(sum, -a.x, b.z, c.y);
    add_product(sum, -a.y, b.x, c.z);
    add_product(sum, -a.z, b.y, c.x);
}

int exact_orientation(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, const glm::vec3& d) {
    ExactSum sum; // (a-d) . (b-d) x (c-d), multiplied out and turned to the sign that is asked for
    add_determinant(sum, c, b, a);
    add_determinant(sum, b, c, d);
    add_determinant(sum, c, a, d);
    add_determinant(sum, a, b, d);
    return sum.sign();
}

} // namespace

int orientation(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, const glm::vec3& d) {
    const glm::dvec3 u = glm::dvec3(a) - glm::dvec3(d), v = glm::dvec3(b) - glm::dvec3(d),
                     w = glm::dvec3(c) - glm::dvec3(d);
    const double vywz = v.y * w.z, vzwy = v.z * w.y, vzwx = v.z * w.x, vxwz = v.x * w.z, vxwy = v.x * w.y,
                 vywx = v.y * w.x;
    const double determinant = u.x * (vywz - vzwy) + u.y * (vzwx - vxwz) + u.z * (vxwy - vywx);
    const double size = std::abs(u.x) * (std::abs(vywz) + std::abs(vzwy)) +
                        std::abs(u.y) * (std::abs(vzwx) + std::abs(vxwz)) +
                        std::abs(u.z) * (std::abs(vxwy) + std::abs(vywx));
    const double bound = 7.7715611723761027e-16 * size; // (7 + 56 * 2^-53) * 2^-53
    if (determinant > bound) return -1;
    if (determinant < -bound) return 1;
    return exact_orientation(a, b, c, d);
}

} // namespace hachure::geometry
