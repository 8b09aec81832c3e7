#include <hachure/runtime/gpu/full_screen.h>
#include <hachure/runtime/gpu/gl.h>

namespace hachure::gpu {

FullScreen::FullScreen() : vertex_array_("full screen") {}

void FullScreen::draw() const {
    vertex_array_.bind();
    gl().DrawArrays(GL_TRIANGLES, 0, 3);
}

} // namespace hachure::gpu
