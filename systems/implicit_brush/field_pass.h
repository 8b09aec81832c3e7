#pragma once

#include <hachure/runtime/gpu/program.h>
#include <hachure/runtime/gpu/shader_library.h>
#include <hachure/runtime/scene/render_context.h>

#include <cstdint>
#include <initializer_list>
#include <string>

namespace hachure {

/// A program that makes a field of the picture, pixel by pixel.
[[nodiscard]] inline gpu::ProgramSource field_program(std::string fragment) {
    return {.vertex = "common/full_screen.vert", .fragment = std::move(fragment)};
}

/// Draws a program over a rectangle of `to`, with textures bound to units 0, 1, ... (0 leaves a unit as it is). Its
/// uniform `area` is the rectangle's first and last pixel.
inline void draw_field(RenderContext& render, gpu::Program& program, const gpu::Rect& rect, std::uint32_t to,
                       std::initializer_list<std::uint32_t> textures) {
    const gpu::Framebuffer& target = render.backend->framebuffer({to});
    target.bind();
    gpu::apply({.viewport = {0, 0, target.width(), target.height()}, .scissor = rect});
    GLuint unit = 0;
    for (const std::uint32_t id : textures) {
        if (id) render.backend->texture(id).bind(unit);
        ++unit;
    }
    program.set("area", glm::ivec4(rect.x, rect.y, rect.x + rect.width - 1, rect.y + rect.height - 1));
    program.use();
    render.full_screen.draw();
}

} // namespace hachure
