#pragma once

#include <hachure/components/camera.h>
#include <hachure/runtime/geometry/shapes.h>
#include <hachure/tests/support/drawn_scene.h>
#include <hachure/tests/support/stamp_images.h>

#include <cstddef>

namespace hachure::test {

/// The normals of a drawn frame: a torus that fills most of it.
inline assets::Image frame_normals(gpu::Context& context, int width, int height) {
    DrawnScene scene(context, Canvas{width, height});
    scene.add(surface_mesh(geometry::torus(1.0, 0.4, 20, 12)),
              Transform{.rotation = glm::angleAxis(0.7f, glm::normalize(glm::vec3(1.0f, 0.4f, 0.2f)))});
    scene.add(Camera{.yfov = 0.7f}, Transform{.translation = {0.0f, 0.0f, 4.0f}});
    scene.renderer().request_aov("normal");
    scene.renderer().render_frame();
    return scene.renderer().read_aov("normal");
}

/// Stamps along the lines of a square part of a frame.
inline StampImage frame_stamps(gpu::Context& context, int size, double radius, const StampVariety& variety = {}) {
    const StampImage whole = stamps_of_normals(frame_normals(context, 2 * size, 2 * size), 0.06, 0.25, radius, variety);
    StampImage part(size, size);
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) part.at(x, y) = whole.at(x + size / 2, y + size / 3);
    return part;
}

} // namespace hachure::test
