#include <hachure/runtime/assets/gltf_numbers.h>
#include <hachure/runtime/assets/gltf_reader.h>

#include <fmt/format.h>
#include <tiny_gltf.h>

namespace hachure::assets {
namespace {

std::vector<glm::vec3> read_displacements(const GltfReader& reader, const std::map<std::string, int>& target,
                                          const std::string& name, std::size_t vertices) {
    const auto it = target.find(name);
    if (it == target.end()) return {};
    const int accessor = it->second;
    const AccessorShape shape = reader.accessors.shape(accessor);
    if (!shape.is_vector(3))
        reader.document.fail(fmt::format("{} of a morph target must be VEC3", name), accessor_pointer(accessor));
    if (shape.count != vertices)
        reader.document.fail(fmt::format("{} of a morph target must have one element per vertex", name),
                             accessor_pointer(accessor));
    auto displacements = reader.accessors.vectors<glm::vec3>(accessor);
    if (zero_non_finite(components_of(displacements)))
        reader.warnings.add("morph displacements that are not finite become zero", accessor_pointer(accessor));
    return displacements;
}

} // namespace

void read_morph_targets(const GltfReader& reader, GltfPrimitiveAt at, Primitive& primitive) {
    const auto& targets = reader.document.model->meshes[at.mesh].primitives[at.primitive].targets;
    const std::vector<std::string>& names = reader.document.target_names[at.mesh];
    const std::size_t vertices = primitive.positions.size();
    for (std::size_t i = 0; i < targets.size(); ++i) {
        MorphTarget target;
        if (i < names.size()) target.name = names[i];
        target.positions = read_displacements(reader, targets[i], "POSITION", vertices);
        // Displacements of what the primitive does not have mean nothing.
        if (!primitive.normals.empty()) target.normals = read_displacements(reader, targets[i], "NORMAL", vertices);
        if (!primitive.tangents.empty()) target.tangents = read_displacements(reader, targets[i], "TANGENT", vertices);
        for (const auto& [name, accessor] : targets[i])
            if (name.starts_with("TEXCOORD_") || name.starts_with("COLOR_"))
                reader.warnings.add("morph targets of texture coordinates and colours are skipped",
                                    accessor_pointer(accessor));
        primitive.morph_targets.push_back(std::move(target));
    }
}

} // namespace hachure::assets
