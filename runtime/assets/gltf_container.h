#pragma once

#include <hachure/runtime/assets/gltf_warnings.h>

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace hachure::assets {

/// The parts of a .gltf or .glb file, pointing into its bytes.
struct GltfChunks {
    std::string_view json;
    std::optional<std::span<const std::byte>> binary; ///< the GLB's BIN chunk, if there is one
};

/// Splits `bytes`, told apart by their first four. Throws hachure::Error about `file`, with the byte offset, when the
/// container is not GLB 2 or its chunks do not lie in it.
[[nodiscard]] GltfChunks split_gltf(std::span<const std::byte> bytes, const std::string& file, GltfWarnings& warnings);

} // namespace hachure::assets
