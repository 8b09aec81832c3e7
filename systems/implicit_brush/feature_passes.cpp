#include <hachure/runtime/scene/draw_list.h>
#include <hachure/runtime/scene/light_list.h>
#include <hachure/runtime/scene/picture_list.h>
#include <hachure/runtime/scene/render_context.h>
#include <hachure/runtime/scene/view.h>
#include <hachure/runtime/scene/view_rects.h>
#include <hachure/systems/implicit_brush/feature_data.h>
#include <hachure/systems/implicit_brush/feature_passes.h>
#include <hachure/systems/implicit_brush/feature_profile.h>
#include <hachure/systems/implicit_brush/feature_quality.h>
#include <hachure/systems/implicit_brush/slope_passes.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace hachure {
namespace {

using gpu::TextureHandle;

struct DataPass {
    TextureHandle slopes, depth_buffer, scratch, scratch_2, data;
};

struct ProfilePass {
    TextureHandle data, depth_buffer, candidates, profile;
};

constexpr int widest_window = 64; // px, of windows in metres; shaders/implicit_brush/window.glsl has the same

bool of_luminance(const World& world, const FeatureKey& key) {
    return key.feature == BrushFeature::luminance_edges || key.source == BrushSource::luminance || !has_relief(world);
}

/// The pixels around those that want profiles that these look at: features, and what features are made of.
int profile_margin(const FeatureKey& key) {
    return (key.world_window ? widest_window : static_cast<int>(std::ceil(1.2f * key.window))) + 2;
}

int feature_margin(const FeatureKey& key) {
    if (key.feature == BrushFeature::contours)
        return contour_reach(key.world_window ? middling_contour_window : key.window) + 2;
    // What diffusion brings from farther than four deviations is nothing.
    const int brought = std::min(key.diffusion, static_cast<int>(std::ceil(4.0 * std::sqrt(0.5 * key.diffusion))));
    return brought + 4;
}

void depend_on(gpu::PassBuilder& pass, const RenderContext& render, const FeatureKey& key, const gpu::Rect& rect) {
    pass.depends_on(key.feature, key.window, render.shaders->generation());
    pass.draws_in(rect);
}

/// Passes of one key.
class KeyPasses {
public:
    KeyPasses(World& world, const FeatureImage& quality, const FeatureRequest& request, int number)
        : world_(world), render_(world.resource_mutable<RenderContext>()), quality_(quality), request_(request),
          number_(number) {}

    FeatureTextures declare(SlopePasses& slopes, const gpu::Rect& rect) {
        const gpu::Rect around = grown(rect, profile_margin(request_.key), world_.resource<View>());
        const TextureHandle data = declare_data(source(slopes), around);
        return {data, declare_profile(data, around, rect)};
    }

private:
    [[nodiscard]] TextureHandle source(SlopePasses& slopes) const {
        const FeatureKey& key = request_.key;
        if (key.feature == BrushFeature::contours)
            return slopes.breaks(0.5f * (key.world_window ? middling_contour_window : key.window));
        return slopes.slopes(of_luminance(world_, key) ? SlopeKind::luminance : SlopeKind::surface, key.diffusion);
    }

    [[nodiscard]] gpu::TextureDesc desc() const {
        const View& view = world_.resource<View>();
        return {view.width, view.height, feature_format(quality_.storage)};
    }

    TextureHandle declare_data(TextureHandle slopes, const gpu::Rect& rect) {
        const FeatureKey key = request_.key;
        const std::string name = fmt::format("feature_data_{}", number_);
        const bool luminance = of_luminance(world_, key), metres = key.world_window;
        const bool masked = key.feature != BrushFeature::contours && !luminance && is_drawn_alone(world_);
        const DataPass& made = render_.graph.add_pass<DataPass>(
            name,
            [&](gpu::PassBuilder& pass, DataPass& data) {
                data.slopes = pass.read(slopes);
                if (metres || masked) data.depth_buffer = pass.read(render_.graph.find("depth_buffer"));
                data.scratch = pass.create(name + "_scratch", desc());
                if (key.feature == BrushFeature::contours) data.scratch_2 = pass.create(name + "_scratch_2", desc());
                data.data = pass.create(name, desc());
                depend_on(pass, render_, key, rect);
                pass.depends_on(luminance);
                if (metres) pass.depends_on(world_.resource<View>().key());
            },
            [&world = world_, &render = render_, key, luminance, masked, rect](const DataPass& data,
                                                                               gpu::PassContext& pass) {
                const auto id = [&](TextureHandle handle) { return handle ? pass.texture(handle) : 0; };
                if (key.world_window) render.view_uniforms.bind(world.resource<View>(), world.resource<LightList>());
                FeatureDataJob{.feature = key.feature,
                               .luminance = luminance,
                               .window = {key.window, key.world_window ? id(data.depth_buffer) : 0},
                               .slopes = pass.texture(data.slopes),
                               .scratch = pass.texture(data.scratch),
                               .scratch_2 = id(data.scratch_2),
                               .to = pass.texture(data.data),
                               .rect = rect,
                               .depth_buffer = masked ? pass.texture(data.depth_buffer) : 0}
                    .run(render);
            });
        return made.data;
    }

    TextureHandle declare_profile(TextureHandle features, const gpu::Rect& around, const gpu::Rect& rect) {
        const FeatureRequest request = request_;
        const std::string name = fmt::format("feature_profile_{}", number_);
        const int taps = quality_.taps, fits = quality_.fits;
        const ProfilePass& made = render_.graph.add_pass<ProfilePass>(
            name,
            [&](gpu::PassBuilder& pass, ProfilePass& data) {
                data.data = pass.read(features);
                if (request.key.world_window) data.depth_buffer = pass.read(render_.graph.find("depth_buffer"));
                const gpu::TextureDesc size = desc();
                data.candidates = pass.create(name + "_candidates", {size.width, size.height, gpu::Format::depth32f});
                data.profile = pass.create(name, size);
                depend_on(pass, render_, request.key, rect);
                pass.depends_on(taps, fits, request.least_height, request.reach);
                if (request.key.world_window) pass.depends_on(world_.resource<View>().key());
            },
            [&world = world_, &render = render_, request, taps, fits, around, rect](const ProfilePass& data,
                                                                                    gpu::PassContext& pass) {
                const bool metres = request.key.world_window;
                if (metres) render.view_uniforms.bind(world.resource<View>(), world.resource<LightList>());
                FeatureProfileJob{.taps = taps,
                                  .fits = fits,
                                  .window = {request.key.window, metres ? pass.texture(data.depth_buffer) : 0},
                                  .least_height = request.least_height,
                                  .reach = request.reach,
                                  .data = pass.texture(data.data),
                                  .candidates = pass.texture(data.candidates),
                                  .to = pass.texture(data.profile),
                                  .valid = around,
                                  .rect = rect}
                    .run(render);
            });
        return made.profile;
    }

    World& world_;
    RenderContext& render_;
    FeatureImage quality_; ///< resolved
    FeatureRequest request_;
    int number_;
};

/// One request for each key, for all that want it.
std::vector<FeatureRequest> one_per_key(std::span<const FeatureRequest> requests) {
    std::vector<FeatureRequest> all;
    for (const FeatureRequest& request : requests) {
        const auto same = std::ranges::find(all, request.key, &FeatureRequest::key);
        if (same == all.end()) {
            all.push_back(request);
            continue;
        }
        same->least_height = std::min(same->least_height, request.least_height);
        same->reach = std::max(same->reach, request.reach);
    }
    return all;
}

} // namespace

void request_feature_sources(const DrawList& list, const PictureList& shown, std::span<const FeatureRequest> requests,
                             FrameRequests& frame) {
    if (requests.empty()) return;
    const bool pictures = !shown.items.empty(), surfaces = !list.items.empty();
    auto& textures = frame.textures;
    textures.insert("normal");
    for (const FeatureRequest& request : requests) {
        const bool luminance =
            request.key.feature == BrushFeature::luminance_edges || request.key.source == BrushSource::luminance;
        if (pictures) textures.insert({"picture_tone", "picture_depth", "picture_normal"});
        if (luminance && surfaces) textures.insert("color"); // in floats: the steps of bytes are a relief, too
    }
}

std::vector<FeatureTextures> FeaturePasses::declare(World& world, const FeatureImage& quality,
                                                    std::span<const FeatureRequest> requests, const gpu::Rect& rect) {
    if (requests.empty() || rect.width <= 0 || rect.height <= 0) return {};
    const std::vector<FeatureRequest> wanted = one_per_key(requests);
    int margin = 0;
    for (const FeatureRequest& request : wanted)
        margin = std::max(margin, profile_margin(request.key) + feature_margin(request.key));
    SlopePasses slopes(world, quality, grown(rect, margin, world.resource<View>()));
    std::vector<FeatureTextures> made;
    for (const FeatureRequest& request : wanted)
        made.push_back(KeyPasses(world, quality, request, static_cast<int>(made.size())).declare(slopes, rect));
    std::vector<FeatureTextures> result;
    for (const FeatureRequest& request : requests) {
        const auto same = std::ranges::find(wanted, request.key, &FeatureRequest::key);
        result.push_back(made[static_cast<std::size_t>(same - wanted.begin())]);
    }
    return result;
}

} // namespace hachure
