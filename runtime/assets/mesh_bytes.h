#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string_view>

namespace hachure::assets {

/// The whole content of a file in memory.
struct MeshBytes {
    std::unique_ptr<char[]> data;
    std::size_t size = 0;

    [[nodiscard]] std::string_view text() const { return {data.get(), size}; }
};

/// Bounds on what is read, compressed or not.
inline constexpr std::size_t max_mesh_bytes = std::size_t{2} << 30;
inline constexpr std::size_t max_inflation = 64; ///< times the compressed size; meshes reach about 10

/// Reads a regular file; one whose name ends in `.gz` is inflated. Errors: hachure::Error when it is missing, a
/// directory or another special file, unreadable, empty, over the bounds, or not sound as gzip.
[[nodiscard]] MeshBytes read_mesh_bytes(const std::filesystem::path& file);

/// The extension in lower case, without `.gz`: ".ply" for "Dragon.PLY.gz".
[[nodiscard]] std::string mesh_extension(const std::filesystem::path& file);

} // namespace hachure::assets
