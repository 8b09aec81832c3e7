#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace hachure::assets {

enum class MeshoptMode : std::uint8_t { attributes, triangles, indices };
enum class MeshoptFilter : std::uint8_t { none, octahedral, quaternion, exponential };

/// How a buffer view is compressed with EXT_meshopt_compression.
struct MeshoptView {
    MeshoptMode mode = MeshoptMode::attributes;
    MeshoptFilter filter = MeshoptFilter::none;
    std::size_t count = 0;  ///< elements
    std::size_t stride = 0; ///< bytes per element, decoded
};

/// What is wrong with the combination of mode, filter, count and stride; nullptr when nothing is.
[[nodiscard]] const char* meshopt_fault(const MeshoptView& view);

/// Decodes into `out`, which has `count * stride` bytes. False when the data is broken. `view` must be without fault;
/// the data need not be: indices may come out of range.
[[nodiscard]] bool decode_meshopt(const MeshoptView& view, std::span<const std::byte> data, std::span<std::byte> out);

} // namespace hachure::assets
