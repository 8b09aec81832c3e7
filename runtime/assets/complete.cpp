#include <hachure/runtime/assets/complete.h>
#include <hachure/runtime/geometry/normals.h>

#include <utility>

namespace hachure::assets {
namespace {

template <class T> void take_from(std::vector<T>& values, const std::vector<std::uint32_t>& source) {
    if (values.empty()) return;
    std::vector<T> taken(source.size());
    for (std::size_t i = 0; i < source.size(); ++i) taken[i] = values[source[i]];
    values = std::move(taken);
}

void complete_normals(Primitive& primitive) {
    geometry::ComputedNormals computed = geometry::vertex_normals(primitive.positions, primitive.indices,
                                                                  {.crease_angle = computed_normals_crease_angle});
    const std::vector<std::uint32_t>& source = computed.source;
    take_from(primitive.positions, source);
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

} // namespace hachure::assets
