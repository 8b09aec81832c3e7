#include <hachure/runtime/assets/gltf.h>
#include <hachure/runtime/assets/gltf_check.h>
#include <hachure/runtime/assets/gltf_reader.h>

#include <tiny_gltf.h>

namespace hachure::assets {
namespace {

void report_extensions(const GltfReader& reader, Model& model) {
    model.extensions = reader.document.model->extensionsUsed;
    for (const std::string& name : model.extensions)
        if (!understands_extension(name)) reader.warnings.add("the extension " + name + " is not understood");
}

} // namespace

Model read_gltf(const std::filesystem::path& file) {
    GltfWarnings warnings;
    const GltfDocument document = open_gltf(file, warnings);
    ByteBudget budget(document.file);
    GltfBuffers buffers(document, budget);
    GltfAccessors accessors(document, buffers, budget);
    const GltfReader reader{document, buffers, accessors, warnings};

    Model model;
    model.file = file;
    report_extensions(reader, model);
    read_textures(reader, model);
    read_materials(reader, model);
    read_cameras(reader, model);
    read_lights(reader, model);
    read_meshes(reader, model);
    read_nodes(reader, model);
    read_skins(reader, model);
    read_animations(reader, model);
    model.warnings = warnings.take();
    return model;
}

} // namespace hachure::assets
