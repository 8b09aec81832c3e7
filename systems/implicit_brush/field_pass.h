#pragma once

#include <hachure/runtime/gpu/program.h>
#include <hachure/runtime/gpu/shader_library.h>
#include <hachure/runtime/scene/render_context.h>

#include <array>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <utility>

namespace hachure {

/// A program that makes a field of the picture, pixel by pixel.
[[nodiscard]] inline gpu::ProgramSource field_program(std::string fragment) {
    return {.vertex = "common/full_screen.vert", .fragment = std::move(fragment)};
}

/// A part of a field: a rectangle, and in it where a depth buffer (reversed) has something, if there is one.
struct FieldPart {
    gpu::Rect rect;
    std::uint32_t depth_buffer = 0;
    bool fresh = true; ///< the field holds anything, also where the depth buffer is empty
};

/// Draws a program over a part of `to`, with textures bound to units 0, 1, ... (0 leaves a unit as it is). Its uniform
/// `area` is the rectangle's first and last pixel. Where the depth buffer is empty the rectangle is 0: pixels that fail
/// a depth test cost nothing anywhere.
inline void draw_field(RenderContext& render, gpu::Program& program, const FieldPart& part, std::uint32_t to,
                       std::initializer_list<std::uint32_t> textures) {
    const gpu::Framebuffer& target = render.backend->framebuffer({to}, part.depth_buffer);
    const gpu::Rect& rect = part.rect;
    target.bind();
    gpu::apply({.viewport = {0, 0, target.width(), target.height()},
                .scissor = rect,
                .depth_test = part.depth_buffer ? gpu::DepthTest::less : gpu::DepthTest::off});
    if (part.depth_buffer && part.fresh) target.clear_color(0, std::array{0.0f, 0.0f, 0.0f, 0.0f});
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
