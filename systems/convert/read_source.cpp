#include <hachure/runtime/assets/extension.h>
#include <hachure/runtime/assets/gltf.h>
#include <hachure/runtime/assets/read_model.h>
#include <hachure/systems/convert/read_source.h>

namespace hachure {

assets::Model read_source(const std::filesystem::path& file) {
    const std::string extension = assets::lower_extension(file);
    std::error_code code;
    const bool is_gltf = extension == ".glb" || extension == ".gltf";
    if (is_gltf && std::filesystem::is_regular_file(file, code)) return assets::read_gltf(file);
    return assets::read_model(file); // which says what is wrong with what is no file
}

} // namespace hachure
