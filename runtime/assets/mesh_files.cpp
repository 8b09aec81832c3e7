#include <hachure/runtime/assets/mesh_bytes.h>
#include <hachure/runtime/assets/mesh_files.h>
#include <hachure/runtime/error.h>

#include <string>
#include <utility>

namespace hachure::assets {
namespace {

using Reader = Model (*)(const std::filesystem::path&);

Reader find_reader(const std::filesystem::path& file) {
    const std::string extension = mesh_extension(file);
    for (const auto& [known, reader] : {std::pair<std::string_view, Reader>{".obj", read_obj},
                                        {".ply", read_ply},
                                        {".off", read_off},
                                        {".stl", read_stl}})
        if (known == extension) return reader;
    return nullptr;
}

} // namespace

bool is_mesh_file(const std::filesystem::path& file) { return find_reader(file) != nullptr; }

Model read_mesh(const std::filesystem::path& file) {
    const Reader reader = find_reader(file);
    if (!reader) throw Error(file.string(), "not a mesh file: its extension is none of .obj, .ply, .off, .stl");
    return reader(file);
}

} // namespace hachure::assets
