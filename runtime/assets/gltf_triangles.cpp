#include <hachure/runtime/assets/gltf_triangles.h>

#include <cstddef>

namespace hachure::assets {

std::vector<std::uint32_t> triangle_list(TriangleMode mode, std::vector<std::uint32_t> vertices) {
    if (mode == TriangleMode::list) {
        vertices.resize(vertices.size() / 3 * 3);
        return vertices;
    }
    std::vector<std::uint32_t> triangles;
    if (vertices.size() < 3) return triangles;
    triangles.reserve((vertices.size() - 2) * 3);
    for (std::size_t i = 0; i + 2 < vertices.size(); ++i) {
        if (mode == TriangleMode::strip) {
            // Every other triangle of a strip runs the other way round.
            const std::size_t odd = i % 2;
            triangles.insert(triangles.end(), {vertices[i], vertices[i + 1 + odd], vertices[i + 2 - odd]});
        } else {
            triangles.insert(triangles.end(), {vertices[i + 1], vertices[i + 2], vertices[0]});
        }
    }
    return triangles;
}

} // namespace hachure::assets
