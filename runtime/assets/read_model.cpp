#include <hachure/runtime/assets/complete.h>
#include <hachure/runtime/assets/extension.h>
#include <hachure/runtime/assets/gltf.h>
#include <hachure/runtime/assets/mesh_files.h>
#include <hachure/runtime/assets/read_model.h>
#include <hachure/runtime/assets/video_file.h>
#include <hachure/runtime/error.h>

#include <algorithm>
#include <array>
#include <string>

namespace hachure::assets {
namespace {

bool is_gltf(const std::filesystem::path& path) {
    const std::string extension = lower_extension(path);
    return extension == ".gltf" || extension == ".glb";
}

/// Plain mesh files say nothing of colour and sides. A mid grey keeps tones away from black and white, which belong to
/// lines and highlights; both sides are drawn, since windings are often wrong.
Material neutral_material() {
    Material material;
    material.name = "neutral";
    material.base_color = {0.35f, 0.35f, 0.35f, 1.0f};
    material.metallic = 0.0f;
    material.double_sided = true;
    return material;
}

/// Gives primitives without a material the neutral one.
void complete_materials(Model& model) {
    const auto neutral = static_cast<std::int32_t>(model.materials.size());
    bool used = false;
    for (Mesh& mesh : model.meshes)
        for (Primitive& primitive : mesh.primitives) {
            if (primitive.material >= 0) continue;
            primitive.material = neutral;
            used = true;
        }
    if (used) model.materials.push_back(neutral_material());
}

} // namespace

InputKind input_kind(const std::filesystem::path& path) {
    static constexpr std::array<std::string_view, 12> images{".png", ".jpg", ".jpeg", ".exr", ".hdr",  ".tga",
                                                             ".bmp", ".tif", ".tiff", ".gif", ".webp", ".ppm"};
    if (is_gltf(path) || is_mesh_file(path)) return InputKind::model;
    if (is_video_name(path)) return InputKind::video;
    if (std::ranges::find(images, lower_extension(path)) != images.end()) return InputKind::image;
    return InputKind::unknown;
}

Model read_model(const std::filesystem::path& path) {
    // Faults that every reader would have to find first.
    std::error_code code;
    const auto status = std::filesystem::status(path, code);
    if (!std::filesystem::exists(status)) throw Error(path.string(), "there is no such file");
    if (std::filesystem::is_directory(status)) throw Error(path.string(), "is a folder, not a model");
    if (input_kind(path) != InputKind::model)
        throw Error(path.string(), "is not a kind of model that can be read: glTF, GLB, OBJ, PLY, OFF or STL");
    Model model = is_gltf(path) ? read_gltf(path) : read_mesh(path);
    if (!is_gltf(path)) complete_materials(model);
    complete_normals(model);
    model.file = path;
    return model;
}

} // namespace hachure::assets
