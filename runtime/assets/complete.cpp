#include <hachure/runtime/assets/complete.h>
#include <hachure/runtime/assets/texcoord_transform.h>
#include <hachure/runtime/geometry/normals.h>
#include <hachure/runtime/geometry/tangents.h>

#include <cmath>
#include <utility>

namespace hachure::assets {
namespace {

template <class T> void take_from(std::vector<T>& values, const std::vector<std::uint32_t>& source) {
    if (values.empty()) return;
    std::vector<T> taken(source.size());
    for (std::size_t i = 0; i < source.size(); ++i) taken[i] = values[source[i]];
    values = std::move(taken);
}

/// Vertex i becomes what vertex source[i] was.
void take_vertices(Primitive& primitive, const std::vector<std::uint32_t>& source) {
    take_from(primitive.positions, source);
    take_from(primitive.normals, source);
    take_from(primitive.tangents, source);
    for (auto& texcoords : primitive.texcoords) take_from(texcoords, source);
    take_from(primitive.colors, source);
    for (auto& joints : primitive.joints) take_from(joints, source);
    for (auto& weights : primitive.weights) take_from(weights, source);
    for (MorphTarget& target : primitive.morph_targets) {
        take_from(target.positions, source);
        take_from(target.normals, source);
        take_from(target.tangents, source);
    }
}

void complete_normals(Primitive& primitive) {
    geometry::ComputedNormals computed = geometry::vertex_normals(primitive.positions, primitive.indices,
                                                                  {.crease_angle = computed_normals_crease_angle});
    // Tangents belong to normals: glTF says that a file's are ignored where it has no normals (section 3.7.2.1).
    primitive.tangents.clear();
    for (MorphTarget& target : primitive.morph_targets) target.tangents.clear();
    take_vertices(primitive, computed.source);
    primitive.normals = std::move(computed.normals);
    primitive.indices = std::move(computed.indices);
    primitive.normals_computed = true;
}

} // namespace

void complete_normals(Model& model) {
    for (Mesh& mesh : model.meshes)
        for (Primitive& primitive : mesh.primitives)
            if (primitive.normals.empty() && !primitive.positions.empty()) complete_normals(primitive);
}

void complete_tangents(Primitive& primitive, const TextureUse& normal_map) {
    std::vector<glm::vec2> texcoords = primitive.texcoords[normal_map.texcoord];
    if (!primitive.tangents.empty() || texcoords.empty()) return;
    const glm::mat3x2 transform = texcoord_transform(normal_map.offset, normal_map.scale, normal_map.rotation);
    for (glm::vec2& texcoord : texcoords) {
        texcoord = transform * glm::vec3(texcoord, 1.0f);
        if (!std::isfinite(texcoord.x) || !std::isfinite(texcoord.y)) texcoord = glm::vec2(0.0f); // a file's 1e38
    }
    geometry::ComputedTangents computed =
        geometry::vertex_tangents(primitive.positions, primitive.normals, texcoords, primitive.indices);
    take_vertices(primitive, computed.source);
    primitive.tangents = std::move(computed.tangents);
    primitive.indices = std::move(computed.indices);
}

} // namespace hachure::assets
