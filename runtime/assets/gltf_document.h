#pragma once

#include <hachure/runtime/assets/gltf_warnings.h>

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace tinygltf {
class Model;
}

namespace hachure::assets {

/// Where the bytes of a buffer are.
struct GltfBufferSource {
    std::optional<std::string> uri; ///< beside the file, or `data:`; the BIN chunk or nothing when absent
    std::size_t byte_length = 0;
};

/// Where an encoded image is: either a uri or a buffer view.
struct GltfImageSource {
    std::string name;
    std::optional<std::string> uri;
    int buffer_view = -1;
};

/// A glTF file, parsed and checked (check_gltf), whose buffers and images are not loaded yet: tinygltf converts the
/// JSON, but never sees a path or a byte of data.
struct GltfDocument {
    GltfDocument();
    GltfDocument(GltfDocument&&) noexcept;
    ~GltfDocument();

    std::filesystem::path path;
    std::string file;                                 ///< the path as error messages show it
    std::vector<std::byte> bytes;                     ///< the whole file
    std::optional<std::span<const std::byte>> binary; ///< the BIN chunk in `bytes`
    std::unique_ptr<tinygltf::Model> model;           ///< its buffers and images are empty; the rest is complete
    std::size_t buffer_view_count = 0; ///< views from here on stand for "no view" (tinygltf wants one under indices)
    std::vector<GltfBufferSource> buffers;
    std::vector<GltfImageSource> images;
    std::vector<std::vector<std::string>> target_names; ///< per mesh, from extras/targetNames; often empty
    std::vector<std::string> node_extras, material_extras, scene_extras; ///< per node, ...: see gltf_extras.h

    /// Throws hachure::Error about this file.
    [[noreturn]] void fail(std::string_view fault, std::string_view where = {}) const;
};

/// Reads, parses and checks the file. Throws hachure::Error.
[[nodiscard]] GltfDocument open_gltf(const std::filesystem::path& path, GltfWarnings& warnings);

} // namespace hachure::assets
