#include <hachure/runtime/scene/render_context.h>

namespace hachure {

void RenderContext::draw_full_screen(std::string_view fragment, const gpu::DrawState& state,
                                     std::initializer_list<std::uint32_t> textures) {
    gpu::apply(state);
    GLuint unit = 0;
    for (const std::uint32_t id : textures) backend->texture(id).bind(unit++);
    shaders->program({.vertex = "common/full_screen.vert", .fragment = std::string(fragment)}).use();
    full_screen.draw();
}

} // namespace hachure
