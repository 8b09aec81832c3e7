# cmake -DSHADER_DIR=... -DSHADERS=a|b -DOUTPUT=... -P EmbedShaders.cmake
# Writes the table behind runtime/gpu/embedded_shaders.h: name and text of each file, as raw string literals.

string(REPLACE "|" ";" names "${SHADERS}")
set(rows "")
foreach(name IN LISTS names)
  file(READ ${SHADER_DIR}/${name} text)
  # A raw literal may hold 64 KiB at least; shader files are far smaller.
  string(APPEND rows "    {\"${name}\", R\"__glsl__(${text})__glsl__\"},\n")
endforeach()
file(WRITE ${OUTPUT}
"#include <hachure/runtime/gpu/embedded_shaders.h>

namespace hachure::gpu {
namespace {
constexpr EmbeddedShader table[] = {
${rows}    {nullptr, nullptr}, // keeps the table non-empty
};
} // namespace

std::span<const EmbeddedShader> embedded_shaders() { return {table, std::size(table) - 1}; }

} // namespace hachure::gpu
")
