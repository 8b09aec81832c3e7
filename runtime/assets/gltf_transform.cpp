#include <hachure/runtime/assets/gltf_transform.h>

#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>

namespace hachure::assets {
namespace {

struct Decomposition {
    glm::dvec3 scale{1.0};
    glm::dquat rotation{1.0, 0.0, 0.0, 0.0};
};

// Valid only when recomposing gives the matrix back.
Decomposition decompose(const glm::dmat3& linear) {
    Decomposition parts;
    for (int i = 0; i < 3; ++i) parts.scale[i] = glm::length(linear[i]);
    if (glm::determinant(linear) < 0.0) parts.scale.x = -parts.scale.x;
    glm::dmat3 rotation(1.0);
    for (int i = 0; i < 3; ++i) rotation[i] = linear[i] / parts.scale[i];
    parts.rotation = glm::normalize(glm::quat_cast(rotation));
    return parts;
}

double largest_difference(const glm::dmat3& a, const glm::dmat3& b) {
    double largest = 0.0;
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row < 3; ++row) largest = std::max(largest, std::abs(a[column][row] - b[column][row]));
    return largest;
}

bool is_affine(const glm::mat4& matrix) {
    return matrix[0].w == 0.0f && matrix[1].w == 0.0f && matrix[2].w == 0.0f && matrix[3].w == 1.0f;
}

} // namespace

void set_transform(Node& node, const glm::mat4& matrix) {
    constexpr double tolerance = 1e-5; // of the largest scale; files write floats with 6 digits or more
    const glm::dmat3 linear{glm::dmat4(matrix)};
    const double size = std::max({glm::length(linear[0]), glm::length(linear[1]), glm::length(linear[2])});
    const double smallest = std::min({glm::length(linear[0]), glm::length(linear[1]), glm::length(linear[2])});
    if (is_affine(matrix) && smallest > tolerance * size) {
        const Decomposition parts = decompose(linear);
        glm::dmat3 recomposed = glm::mat3_cast(parts.rotation);
        for (int i = 0; i < 3; ++i) recomposed[i] *= parts.scale[i];
        if (largest_difference(recomposed, linear) <= tolerance * size) {
            node.translation = glm::vec3(matrix[3]);
            node.rotation = glm::quat(parts.rotation);
            node.scale = glm::vec3(parts.scale);
            return;
        }
    }
    node.matrix = matrix;
}

} // namespace hachure::assets
