#pragma once

#include <hachure/runtime/gpu/vertex_array.h>

namespace hachure::gpu {

/// One triangle that covers the viewport, for passes over every pixel. The vertex shader is
/// shaders/common/full_screen.vert; it needs no vertex buffer, only this (empty) vertex array.
class FullScreen {
public:
    FullScreen();

    /// Draws with the program, framebuffer and state in use (glDrawArrays).
    void draw() const;

private:
    VertexArray vertex_array_;
};

} // namespace hachure::gpu
