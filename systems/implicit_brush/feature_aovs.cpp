#include <hachure/runtime/scene/render_context.h>
#include <hachure/runtime/scene/view.h>
#include <hachure/systems/implicit_brush/feature_aovs.h>
#include <hachure/systems/implicit_brush/field_pass.h>

#include <algorithm>
#include <array>

namespace hachure {
namespace {

struct FeatureAov {
    const char* name;
    const char* doc;
    std::vector<std::string> channels;
    bool of_profile;
    const char* code; ///< of the shader: `texel` as FeatureTextures has it
    std::array<float, 4> nothing;
};

const std::array<FeatureAov, 6>& feature_aovs() {
    static const std::array<FeatureAov, 6> all{{
        {"feature_height",
         "height of the first brush's feature at each pixel, without unit; 0 where there is none",
         {"feature_height"},
         false,
         "texel.r",
         {}},
        {"feature_direction",
         "unit direction across that feature, of either sign, in the picture; 0 where there is none",
         {"feature_direction.X", "feature_direction.Y"},
         false,
         "direction_of(texel.gb)",
         {}},
        {"feature_singularity",
         "how much the direction changes around the pixel, or a contour cuts it off: 0 to 1",
         {"feature_singularity"},
         false,
         "texel.a",
         {}},
        {"profile_distance",
         "pixels to the line of that feature; 1e10 where a pixel has none",
         {"profile_distance"},
         true,
         "texel.b > 0.0 ? length(texel.rg) : 1e10",
         {1e10f}},
        {"profile_height",
         "height of the feature at the pixel's line; 0 where it has none",
         {"profile_height"},
         true,
         "texel.b",
         {}},
        {"profile_curvature",
         "how far the height falls over half a window beside the line, by its second derivative; 0 where there is none",
         {"profile_curvature"},
         true,
         "texel.a",
         {}},
    }};
    return all;
}

struct AovPass {
    gpu::TextureHandle texture, aov;
};

void declare_aov(World& world, const FeatureAov& aov, gpu::TextureHandle texture, const gpu::Rect& rect) {
    RenderContext& render = world.resource_mutable<RenderContext>();
    const View& view = world.resource<View>();
    const bool two = aov.channels.size() == 2;
    render.graph.add_pass<AovPass>(
        aov.name,
        [&](gpu::PassBuilder& pass, AovPass& data) {
            data.texture = pass.read(texture);
            data.aov = pass.create(aov.name, {view.width, view.height, two ? gpu::Format::rg32f : gpu::Format::r32f});
            render.graph.publish(aov.name, data.aov);
            pass.depends_on(rect, render.shaders->generation());
        },
        [&render, &aov, two, rect](const AovPass& data, gpu::PassContext& pass) {
            const gpu::Framebuffer& target = render.backend->framebuffer({pass.texture(data.aov)});
            gpu::apply({.viewport = {0, 0, target.width(), target.height()}});
            target.clear_color(0, aov.nothing);
            gpu::ProgramSource source = field_program("implicit_brush/feature_aov.frag");
            source.defines = {{"AOV", aov.code}, {"AOV_TYPE", two ? "vec2" : "float"}};
            draw_field(render, render.shaders->program(source), {rect}, pass.texture(data.aov),
                       {pass.texture(data.texture)});
        });
}

} // namespace

void know_feature_aovs(FrameRequests& requests) {
    for (const FeatureAov& aov : feature_aovs()) requests.known.push_back({aov.name, aov.doc, aov.channels});
}

bool wants_feature_aovs(const FrameRequests& requests) {
    return std::ranges::any_of(feature_aovs(), [&](const FeatureAov& aov) { return requests.wants(aov.name); });
}

void declare_feature_aovs(World& world, const FeatureTextures& textures, const gpu::Rect& rect) {
    for (const FeatureAov& aov : feature_aovs())
        if (world.resource<FrameRequests>().wants(aov.name))
            declare_aov(world, aov, aov.of_profile ? textures.profile : textures.data, rect);
}

} // namespace hachure
