#include <hachure/systems/model/merge_primitives.h>

#include <algorithm>
#include <type_traits>

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

/// The same arrays of all primitives, one after the other; empty where none has any.
template <class Get> auto joined(std::span<const Primitive> primitives, Get get) {
    std::remove_cvref_t<decltype(get(primitives.front()))> all;
    const bool wanted = std::ranges::any_of(primitives, [&](const Primitive& p) { return !get(p).empty(); });
    for (const Primitive& p : primitives)
        append(all, get(p), p.positions.size(), wanted, typename decltype(all)::value_type(0));
    return all;
}

geometry::SkinWeights joined_weights(std::span<const Primitive> primitives, std::size_t vertices, std::size_t joints) {
    const auto joints_of = [&](int set) {
        return joined(
            primitives, [set](const Primitive& p) -> const auto& { return p.joints[set]; });
    };
    const auto weights_of = [&](int set) {
        return joined(
            primitives, [set](const Primitive& p) -> const auto& { return p.weights[set]; });
    };
    return geometry::pack_skin_weights(vertices, joints, joints_of(0), weights_of(0), joints_of(1), weights_of(1));
}

geometry::MorphTargets joined_morphs(std::span<const Primitive> primitives, std::size_t vertices) {
    std::size_t count = 0;
    for (const Primitive& p : primitives) count = std::max(count, p.morph_targets.size());
    std::vector<assets::MorphTarget> targets(count);
    std::vector<geometry::MorphDeltas> deltas;
    const std::vector<glm::vec3> none;
    for (std::size_t t = 0; t < count; ++t) {
        const auto all = [&](std::vector<glm::vec3> assets::MorphTarget::*array) {
            return joined(primitives, [&, t, array](const Primitive& p) -> const std::vector<glm::vec3>& {
                return t < p.morph_targets.size() ? p.morph_targets[t].*array : none;
            });
        };
        targets[t].positions = all(&assets::MorphTarget::positions);
        targets[t].normals = all(&assets::MorphTarget::normals);
        targets[t].tangents = all(&assets::MorphTarget::tangents);
        deltas.push_back({targets[t].positions, targets[t].normals, targets[t].tangents});
    }
    return {vertices, deltas};
}

} // namespace

SurfaceMesh merge_primitives(std::string_view name, std::span<const Primitive> primitives,
                             const std::function<SurfaceMaterial(std::int32_t)>& material, std::size_t joint_count) {
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
    if (joint_count > 0) mesh.skin = joined_weights(primitives, mesh.positions.size(), joint_count);
    mesh.morphs = joined_morphs(primitives, mesh.positions.size());
    return mesh;
}

} // namespace hachure
