#pragma once

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace hachure::animation {

/// The nearest float that is finite.
inline float finite_float(double value) {
    constexpr double most = std::numeric_limits<float>::max();
    return static_cast<float>(std::clamp(value, -most, most));
}

/// a at 0 and b at 1, both exactly; no overflow between finite ends.
inline float lerp(float a, float b, float u) { return a * (1.0f - u) + b * u; }

/// The unit quaternion along q, or `otherwise` when q is none.
inline glm::quat unit_or(const glm::quat& q, const glm::quat& otherwise) {
    const float length2 = glm::dot(q, q);
    return length2 > 0.0f ? q * (1.0f / std::sqrt(length2)) : otherwise;
}

/// From a (u = 0) to b (u = 1) at an even speed, the short way round (glTF 2.0, appendix C.4). Both are unit.
inline glm::quat slerp_short(const glm::quat& a, const glm::quat& b, float u) {
    const float d = glm::dot(a, b);
    const float cosine = std::abs(d);
    float from = 1.0f - u, to = u;
    // Nearer than that, the sines are as good as their angles, and the angle's own rounding would show.
    if (cosine < 0.99999f) {
        const float angle = std::acos(cosine);
        const float scale = 1.0f / std::sqrt(1.0f - cosine * cosine);
        from = std::sin(from * angle) * scale;
        to = std::sin(to * angle) * scale;
    }
    return unit_or(a * from + b * (d < 0.0f ? -to : to), a);
}

/// glTF's cubic spline (2.0, appendix C.5) at `u` of the way between two keys that lie `length` seconds apart. In
/// double precision, where tangents of any finite size can't overflow.
struct HermiteWeights {
    double value0, tangent0, value1, tangent1;

    HermiteWeights(double u, double length)
        : value0((2.0 * u - 3.0) * u * u + 1.0), tangent0(length * (((u - 2.0) * u + 1.0) * u)),
          value1((3.0 - 2.0 * u) * u * u), tangent1(length * ((u - 1.0) * u * u)) {}

    [[nodiscard]] double mix(float v0, float out0, float v1, float in1) const {
        return value0 * v0 + tangent0 * out0 + value1 * v1 + tangent1 * in1;
    }
};

} // namespace hachure::animation
