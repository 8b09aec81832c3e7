#include <hachure/runtime/scene/view_uniforms.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace hachure {
namespace {

// std140 twins of shaders/common/view.glsl and lights.glsl.
struct ViewBlock {
    glm::mat4 view_from_world, clip_from_view, clip_from_world;
    glm::vec4 eye;
    glm::vec2 viewport;
    float pixel_size;
    float padding = 0.0f;
};

struct LightBlockItem {
    glm::vec4 position, direction, color, cone;
};

struct LightBlock {
    std::array<LightBlockItem, LightList::max_lights> lights{};
    std::int32_t count = 0;
    std::array<std::int32_t, 3> padding{};
};

ViewBlock view_block(const View& view) {
    return {view.view_from_world,
            view.clip_from_view,
            view.clip_from_world,
            view.eye,
            {static_cast<float>(view.width), static_cast<float>(view.height)},
            view.pixel_size};
}

LightBlock light_block(const LightList& list) {
    LightBlock block;
    const std::size_t count = std::min(list.lights.size(), block.lights.size());
    for (std::size_t i = 0; i < count; ++i) {
        const ShadingLight& light = list.lights[i];
        block.lights[i] = {light.position,
                           glm::vec4(light.direction, light.range),
                           glm::vec4(light.color, light.spot ? 1.0f : 0.0f),
                           {std::cos(light.inner_cone), std::cos(light.outer_cone), light.gaze ? 1.0f : 0.0f, 0.0f}};
    }
    block.count = static_cast<std::int32_t>(count);
    return block;
}

} // namespace

ViewUniforms::ViewUniforms()
    : view_buffer_(sizeof(ViewBlock), gpu::BufferUsage::dynamic, "view"),
      light_buffer_(sizeof(LightBlock), gpu::BufferUsage::dynamic, "lights") {}

void ViewUniforms::bind(const View& view, const LightList& lights) {
    if (!filled_ || !(view == view_)) {
        const ViewBlock block = view_block(view);
        view_buffer_.update(std::span<const ViewBlock>(&block, 1));
        view_ = view;
    }
    if (!filled_ || !(lights == lights_)) {
        const LightBlock block = light_block(lights);
        light_buffer_.update(std::span<const LightBlock>(&block, 1));
        lights_ = lights;
    }
    filled_ = true;
    view_buffer_.bind_base(gpu::BufferBinding::uniform, 0);
    light_buffer_.bind_base(gpu::BufferBinding::uniform, 1);
}

} // namespace hachure
