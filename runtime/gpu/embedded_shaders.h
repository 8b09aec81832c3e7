#pragma once

#include <iterator>
#include <span>

namespace hachure::gpu {

/// A file of shaders/ as it was when the library was built.
struct EmbeddedShader {
    const char* name; ///< path below shaders/, for example "gooch/gooch.frag"
    const char* text; ///< zero-terminated GLSL
};

/// Every embedded shader, sorted by name. The build generates it (cmake/EmbedFiles.cmake).
[[nodiscard]] std::span<const EmbeddedShader> embedded_shaders();

} // namespace hachure::gpu
