#pragma once

#include <hachure/runtime/gpu/gl.h>
#include <hachure/runtime/gpu/texture_desc.h>

#include <cstdint>
#include <string_view>

namespace hachure::gpu {

/// How the values of a format read in a shader.
enum class FormatKind : std::uint8_t {
    normalized, ///< 8-bit integers read as 0..1
    floating,
    unsigned_integer, ///< usampler2D; never filtered
    depth,            ///< 0..1
};

/// A format in OpenGL's terms.
struct GlFormat {
    std::string_view name;      ///< as in gpu::Format
    GLenum internal_format = 0; ///< sized
    GLenum pixel_format = 0;    ///< of pixels handed over or read back
    int channels = 0;           ///< 1..4
    FormatKind kind = FormatKind::normalized;
};

[[nodiscard]] const GlFormat& gl_format(Format format);

} // namespace hachure::gpu
