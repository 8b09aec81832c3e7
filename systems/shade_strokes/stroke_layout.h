#pragma once

#include <cstddef>
#include <cstdint>

/// Sizes that shaders/shade_strokes and the CPU agree about.
namespace hachure::stroke_layout {

inline constexpr std::size_t vector_bytes = 16;
inline constexpr std::size_t seen_bytes = 96; ///< Seen of data.glsl
inline constexpr std::size_t group = 64;      ///< threads of a work group, of every shader

// batches.glsl
inline constexpr std::size_t batches = 34;
inline constexpr std::uint32_t most_ribbons = 4 * 384; ///< of a segment: 4 a stroke, where they bend

/// glDrawElementsIndirect.
struct DrawCommand {
    std::uint32_t indices, instances, first_index;
    std::int32_t base_vertex;
    std::uint32_t first_instance;
};

} // namespace hachure::stroke_layout
