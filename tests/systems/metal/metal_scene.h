#pragma once

#include <hachure/components/light.h>
#include <hachure/components/metal.h>
#include <hachure/runtime/assets/image.h>
#include <hachure/systems/metal/metal_frame.h>
#include <hachure/tests/support/drawn_scene.h>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>

namespace hachure::test {

/// The rotation of a directional light that lies that way.
inline glm::quat light_rotation(const glm::vec3& towards) {
    const glm::vec3 z = glm::normalize(towards);
    const glm::vec3 x = glm::normalize(glm::cross(std::abs(z.y) < 0.9f ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0), z));
    return glm::quat_cast(glm::mat3(x, glm::cross(z, x), z));
}

inline Entity add_light(DrawnScene& scene, const glm::vec3& towards) {
    return scene.world().create_with(Transform{.rotation = light_rotation(towards)}, Light{.rig = LightRig::world});
}

/// The picture in linear light, before it is encoded.
inline assets::Image draw_linear(DrawnScene& scene) {
    scene.renderer().request_aov("color");
    scene.renderer().render_frame();
    return scene.renderer().read_aov("color");
}

/// One object before an orthographic camera that looks along -Z from a little above, `half_height` metres in half the
/// picture's height.
struct MetalScene {
    DrawnScene scene;
    Entity object, camera, light;

    MetalScene(gpu::Context& context, Canvas canvas, SurfaceMesh mesh, const Metal& metal,
               const glm::vec3& towards_light, float half_height = 2.0f, const Transform& place = {})
        : scene(context, canvas), object(scene.add(std::move(mesh), place)),
          camera(scene.add(Camera{.projection = Projection::orthographic, .ymag = half_height, .zfar = 100.0f},
                           {.translation = {0.0f, 0.0f, 20.0f}})),
          light(add_light(scene, towards_light)) {
        scene.world().add(object, metal);
    }

    void turn_light(const glm::vec3& towards) {
        scene.world().get_mutable<Transform>(light).rotation = light_rotation(towards);
    }
    assets::Image draw() { return draw_linear(scene); }
    const MetalFrame& frame() { return scene.world().resource<MetalFrame>(); }
};

inline bool all_finite(const assets::Image& image) {
    const std::size_t count = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height) *
                              static_cast<std::size_t>(image.channels);
    return std::all_of(image.f32(), image.f32() + count, [](float v) { return std::isfinite(v); });
}

/// The largest change of any channel of any pixel.
inline double largest_change(const assets::Image& a, const assets::Image& b) {
    const std::size_t count =
        static_cast<std::size_t>(a.width) * static_cast<std::size_t>(a.height) * static_cast<std::size_t>(a.channels);
    double worst = 0.0;
    for (std::size_t i = 0; i < count; ++i) worst = std::max(worst, std::abs(double(a.f32()[i]) - double(b.f32()[i])));
    return worst;
}

/// The share of pixels with a channel that changed by more than `limit`.
inline double changed_share(const assets::Image& a, const assets::Image& b, double limit) {
    const std::size_t pixels = static_cast<std::size_t>(a.width) * static_cast<std::size_t>(a.height);
    const auto channels = static_cast<std::size_t>(a.channels);
    std::size_t changed = 0;
    for (std::size_t p = 0; p < pixels; ++p) {
        double worst = 0.0;
        for (std::size_t c = 0; c < channels; ++c)
            worst = std::max(worst, std::abs(double(a.f32()[p * channels + c]) - double(b.f32()[p * channels + c])));
        changed += worst > limit ? 1 : 0;
    }
    return static_cast<double>(changed) / static_cast<double>(pixels);
}

} // namespace hachure::test
