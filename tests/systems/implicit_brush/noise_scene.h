#pragma once

#include <hachure/runtime/scene/draw_list.h>
#include <hachure/runtime/scene/frame_requests.h>
#include <hachure/runtime/scene/render_context.h>
#include <hachure/systems/implicit_brush/brush_noise.h>
#include <hachure/tests/support/drawn_scene.h>

#include <glm/vec4.hpp>

#include <memory>
#include <string>
#include <vector>

namespace hachure::test {

/// Four channels by pixel, the bottom row first.
struct NoiseImage {
    int width = 0, height = 0;
    std::vector<glm::vec4> values;

    [[nodiscard]] const glm::vec4& at(int x, int y) const {
        return values[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)];
    }
};

/// A scene whose frames hold fields of noise, as a system that paints with brushes would ask for.
class NoiseScene : public DrawnScene {
public:
    NoiseScene(gpu::Context& context, Canvas canvas, std::vector<BrushNoiseKey> noise)
        : DrawnScene(context, canvas), keys(std::move(noise)) {
        for (std::size_t i = 0; i < keys.size(); ++i)
            frame_requests(world()).known.push_back({name(i), "noise", {"x", "y", "z", "w"}});
        app()
            .add_system(Stage::render, "noise_scene",
                        [this, passes = std::make_shared<BrushNoisePasses>()](World& w) {
                            const Canvas& size = w.resource<Canvas>();
                            const gpu::Rect all{0, 0, size.width, size.height};
                            const auto textures = passes->declare(w, keys, rect.width > 0 ? rect : all);
                            for (std::size_t i = 0; i < textures.size(); ++i)
                                w.resource_mutable<RenderContext>().graph.publish(name(i), textures[i]);
                        })
            .after("velocity.pass")
            .before("compose.passes");
        for (std::size_t i = 0; i < keys.size(); ++i) renderer().request_aov(name(i));
    }

    [[nodiscard]] NoiseImage noise(std::size_t index = 0) { return read(name(index)); }

    /// Any AOV that was requested, missing channels 0.
    [[nodiscard]] NoiseImage read(const std::string& aov) {
        const assets::Image image = renderer().read_aov(aov);
        NoiseImage result{image.width, image.height, {}};
        for (int y = image.height - 1; y >= 0; --y)
            for (int x = 0; x < image.width; ++x) {
                const float* pixel = image.f32() + static_cast<std::ptrdiff_t>(image.channels) * (y * image.width + x);
                glm::vec4 value(0.0f);
                for (int c = 0; c < image.channels; ++c) value[c] = pixel[c];
                result.values.push_back(value);
            }
        return result;
    }

    std::vector<BrushNoiseKey> keys; ///< as many as at first
    gpu::Rect rect;                  ///< what is asked for; everything where it has no area

private:
    static std::string name(std::size_t index) { return "noise " + std::to_string(index); }
};

} // namespace hachure::test
