#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <span>
#include <vector>

/// Small conversions that the steps of the glTF reader share.
namespace hachure::assets {

/// Doubles that the check found to fit a float.
[[nodiscard]] std::vector<float> to_floats(const std::vector<double>& numbers);

/// `Vector::length()` numbers; `fallback` when there are none.
template <class Vector> [[nodiscard]] Vector to_vector(const std::vector<double>& numbers, const Vector& fallback) {
    if (numbers.size() < static_cast<std::size_t>(Vector::length())) return fallback;
    Vector vector;
    for (int i = 0; i < Vector::length(); ++i) vector[i] = static_cast<float>(numbers[static_cast<std::size_t>(i)]);
    return vector;
}

[[nodiscard]] bool all_finite(std::span<const float> numbers);

/// Replaces what is not finite by zero; true when there was any.
bool zero_non_finite(std::span<float> numbers);

/// The components of an array of vectors.
template <class Vector> [[nodiscard]] std::span<float> components_of(std::vector<Vector>& vectors) {
    return {reinterpret_cast<float*>(vectors.data()), vectors.size() * (sizeof(Vector) / sizeof(float))};
}

} // namespace hachure::assets
