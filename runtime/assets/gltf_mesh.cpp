#include <hachure/runtime/assets/gltf_numbers.h>
#include <hachure/runtime/assets/gltf_reader.h>

#include <fmt/format.h>
#include <tiny_gltf.h>

namespace hachure::assets {
namespace {

Mesh read_mesh(const GltfReader& reader, std::size_t index) {
    const tinygltf::Mesh& source = reader.document.model->meshes[index];
    const std::string where = fmt::format("/meshes/{}", index);
    Mesh mesh;
    mesh.name = source.name;
    mesh.morph_weights = to_floats(source.weights);
    for (std::size_t i = 0; i < source.primitives.size(); ++i) {
        if (source.primitives[i].targets.size() != source.primitives.front().targets.size())
            reader.document.fail("has primitives of one mesh with different numbers of morph targets", where);
        if (auto primitive = read_primitive(reader, {index, i})) mesh.primitives.push_back(std::move(*primitive));
    }
    const std::size_t targets = source.primitives.empty() ? 0 : source.primitives.front().targets.size();
    if (!mesh.morph_weights.empty() && mesh.morph_weights.size() != targets) {
        reader.warnings.add("morph weights that do not match the morph targets are dropped", where);
        mesh.morph_weights.clear();
    }
    return mesh;
}

} // namespace

void read_meshes(const GltfReader& reader, Model& model) {
    for (std::size_t i = 0; i < reader.document.model->meshes.size(); ++i) model.meshes.push_back(read_mesh(reader, i));
}

} // namespace hachure::assets
