#pragma once

#include <hachure/runtime/assets/image.h>
#include <hachure/runtime/scene/view_rects.h>
#include <hachure/systems/implicit_brush/feature_aovs.h>
#include <hachure/systems/implicit_brush/feature_passes.h>
#include <hachure/systems/implicit_brush/feature_quality.h>
#include <hachure/systems/picture/picture.h>
#include <hachure/tests/support/drawn_scene.h>
#include <hachure/tests/support/feature_finding.h>

#include <memory>
#include <utility>
#include <vector>

namespace hachure::test {

/// The channels of an AOV at (x, y), y up.
struct AovPixels {
    assets::Image image;
    [[nodiscard]] const float* at(int x, int y) const {
        const auto row = static_cast<std::size_t>(image.height - 1 - y);
        return image.f32() + static_cast<std::size_t>(image.channels) *
                                 (row * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x));
    }
};

/// A scene in which features are found, without brushes.
class FeatureScene {
public:
    FeatureScene(gpu::Context& context, Canvas canvas)
        : scene_(context, canvas, register_without_brushes), passes_(std::make_unique<FeaturePasses>()) {
        App& app = scene_.app();
        know_feature_aovs(frame_requests(app.world()));
        app.add_system(Stage::material, "test.request_features",
                       [this](const DrawList& list, const PictureList& pictures, FrameRequests& frame) {
                           request_feature_sources(list, pictures, requests_, frame);
                       })
            .after("surface.collect")
            .after("picture.collect");
        app.add_system(Stage::render, "test.features", [this](World& world) { declare(world); })
            .after("surface.passes")
            .after("gooch.pass")
            .after("picture.passes")
            .before("compose.passes");
    }

    [[nodiscard]] DrawnScene& scene() { return scene_; }
    [[nodiscard]] World& world() { return scene_.world(); }

    /// The first is that of the AOVs.
    void want(std::vector<FeatureRequest> requests) { requests_ = std::move(requests); }
    void want(const FeatureKey& key) { want(std::vector<FeatureRequest>{{key}}); }
    /// Where features are found; everywhere, unless it is called.
    void confine(const gpu::Rect& rect) { rect_ = rect; }

    /// Draws a frame with all the AOVs of features; read them with aov().
    void draw() {
        for (const char* name : {"feature_height", "feature_direction", "feature_singularity", "profile_distance",
                                 "profile_height", "profile_curvature"})
            scene_.renderer().request_aov(name);
        scene_.renderer().render_frame();
    }

    [[nodiscard]] AovPixels aov(const char* name) { return {scene_.renderer().read_aov(name)}; }

    /// The profiles of the frame that was drawn last.
    [[nodiscard]] const std::vector<PixelProfile>& profiles() const { return profiles_; }

private:
    static void register_without_brushes(App& app) {
        app.add_component<FeatureImage>();
        register_transform(app);
        register_camera(app);
        register_light(app);
        register_surface(app);
        register_picture(app);
        register_gooch(app);
        register_compose(app);
    }

    void declare(World& world) {
        const View& view = world.resource<View>();
        const gpu::Rect rect = rect_.width > 0 ? rect_ : gpu::Rect{0, 0, view.width, view.height};
        const FeatureImage* quality = world.find<FeatureImage>(view.camera);
        const std::vector<FeatureTextures> textures =
            passes_->declare(world, resolved(quality ? *quality : FeatureImage{}), requests_, rect);
        if (textures.empty()) return;
        declare_feature_aovs(world, textures.front(), rect);
        struct Read {
            gpu::TextureHandle profile;
        };
        RenderContext& render = world.resource_mutable<RenderContext>();
        render.graph.add_pass<Read>(
            "read_profiles",
            [&](gpu::PassBuilder& pass, Read& data) {
                data.profile = pass.read(textures.front().profile);
                pass.side_effect();
            },
            [this, &render](const Read& data, gpu::PassContext& pass) {
                const std::vector<float> t =
                    render.backend->texture(pass.texture(data.profile)).read_floats(gpu::RowOrder::bottom_first);
                profiles_.resize(t.size() / 4);
                for (std::size_t i = 0; i < profiles_.size(); ++i)
                    profiles_[i] = {{t[4 * i], t[4 * i + 1]}, t[4 * i + 2], t[4 * i + 3]};
            });
    }

    DrawnScene scene_;
    std::unique_ptr<FeaturePasses> passes_;
    std::vector<FeatureRequest> requests_;
    gpu::Rect rect_;
    std::vector<PixelProfile> profiles_;
};

} // namespace hachure::test
