#include <hachure/systems/model/merge_primitives.h>

#include <algorithm>

namespace hachure {
namespace {

using assets::Primitive;

/// Appends `values`, or `count` neutral ones where the primitive has none but another one does.
template <class T>
void append(std::vector<T>& all, const std::vector<T>& values, std::size_t count, bool wanted, T neutral) {
    if (!wanted) return;
    if (values.empty())
        all.insert(all.end(), count, neutral);
    else
        all.insert(all.end(), values.begin(), values.end());
}

} // namespace

SurfaceMesh merge_primitives(std::string_view name, std::span<const Primitive> primitives,
                             const std::function<SurfaceMaterial(std::int32_t)>& material) {
    SurfaceMesh mesh;
    mesh.name = name;
    const bool texcoords = std::ranges::any_of(primitives, [](const Primitive& p) { return !p.texcoords[0].empty(); });
    const bool normal_texcoords =
        std::ranges::any_of(primitives, [](const Primitive& p) { return !p.texcoords[1].empty(); });
    const bool tangents = std::ranges::any_of(primitives, [](const Primitive& p) { return !p.tangents.empty(); });
    const bool colors = std::ranges::any_of(primitives, [](const Primitive& p) { return !p.colors.empty(); });
    for (const Primitive& primitive : primitives) {
        const auto first_vertex = static_cast<std::uint32_t>(mesh.positions.size());
        const std::size_t count = primitive.positions.size();
        append(mesh.positions, primitive.positions, count, true, glm::vec3(0.0f));
        append(mesh.normals, primitive.normals, count, true, glm::vec3(0.0f, 1.0f, 0.0f));
        append(mesh.texcoords, primitive.texcoords[0], count, texcoords, glm::vec2(0.0f));
        append(mesh.normal_texcoords, primitive.texcoords[1].empty() ? primitive.texcoords[0] : primitive.texcoords[1],
               count, normal_texcoords, glm::vec2(0.0f));
        append(mesh.tangents, primitive.tangents, count, tangents, glm::vec4(1.0f, 0.0f, 0.0f, 1.0f));
        append(mesh.colors, primitive.colors, count, colors, glm::vec4(1.0f));
        const auto first_index = static_cast<std::uint32_t>(mesh.indices.size());
        for (const std::uint32_t index : primitive.indices) mesh.indices.push_back(first_vertex + index);
        mesh.submeshes.push_back(
            {first_index, static_cast<std::uint32_t>(primitive.indices.size()), material(primitive.material)});
        if (primitive.tangents.empty() || (primitive.texcoords[0].empty() && primitive.texcoords[1].empty()))
            mesh.submeshes.back().material.normal_texture = -1; // others may have what it lacks
    }
    return mesh;
}

} // namespace hachure
