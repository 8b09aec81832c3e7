#include <hachure/components/compose.h>
#include <hachure/components/paper.h>
#include <hachure/runtime/app/app.h>
#include <hachure/runtime/scene/line_layer.h>
#include <hachure/runtime/scene/render_context.h>
#include <hachure/runtime/scene/view.h>
#include <hachure/systems/paper/height_map.h>
#include <hachure/systems/paper/paper.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

namespace hachure {
namespace {

SheetKey sheet_key(const Paper& paper, const View& view) {
    const float unit = paper.scale_unit == PaperUnit::picture ? 0.001f * static_cast<float>(view.height) : 1.0f;
    const float scale = std::clamp(paper.scale * unit, 0.5f, 32.0f);
    if (!paper.file.empty()) return {.file = paper.file, .scale = scale};
    return {.kind = paper.kind, .seed = static_cast<std::uint32_t>(paper.seed), .scale = scale};
}

constexpr float rounding = 1.5f / 255.0f; ///< what writing and reading an sRGB colour may do to it

/// A linear colour, moved by so much of its encoded value.
glm::vec3 moved(const glm::vec3& color, float by) {
    glm::vec3 result;
    for (int c = 0; c < 3; ++c) {
        const float x = color[c];
        const float encoded = (x <= 0.0031308f ? 12.92f * x : 1.055f * std::pow(x, 1.0f / 2.4f) - 0.055f) + by;
        result[c] = encoded <= 0.04045f ? encoded / 12.92f : std::pow((encoded + 0.055f) / 1.055f, 2.4f);
    }
    return result;
}

struct PaperTextures {
    gpu::TextureHandle layer, color, papered;
};

/// Keeps the sheet on the GPU while it stays the same.
class PaperPass {
public:
    void declare(World& world) {
        LineLayer& lines = world.resource_mutable<LineLayer>();
        lines.laid = false;
        RenderContext& render = world.resource_mutable<RenderContext>();
        const View& view = world.resource<View>();
        const Paper* paper = world.find<Paper>(view.camera);
        const bool lined = static_cast<bool>(render.graph.find("line_layer"));
        if (!paper || paper->strength <= 0.0f || !(paper->on_shading || (paper->on_lines && lined))) return;
        read_sheet(sheet_key(*paper, view));
        const Compose* compose = world.find<Compose>(view.camera);
        settings_ = {*paper, (compose ? *compose : Compose{}).background, lines.rect(), lined};
        lines.laid = lined;
        add_pass(render);
    }

private:
    struct Settings {
        Paper paper;
        glm::vec3 bare{1.0f};
        gpu::Rect line_rect;
        bool lined = false;
    };

    /// Ahead of the pass: a fault of a file ends the frame before anything is drawn.
    void read_sheet(const SheetKey& key) {
        if (key_ == key) return;
        key_.reset();
        const HeightMap sheet = make_sheet(key);
        heights_ = gpu::Texture({sheet.width, sheet.height, gpu::Format::r8}, "paper");
        heights_.upload(std::span<const std::uint8_t>(sheet.texels));
        heights_.set_sampling({.min = gpu::Filter::nearest,
                               .mag = gpu::Filter::nearest,
                               .wrap_u = gpu::Wrap::repeat,
                               .wrap_v = gpu::Wrap::repeat});
        key_ = key;
        ++version_;
    }

    void add_pass(RenderContext& render) {
        gpu::FrameGraph& graph = render.graph;
        const Paper& paper = settings_.paper;
        const gpu::Rect& rect = settings_.line_rect;
        graph.add_pass<PaperTextures>(
            "paper",
            [&](gpu::PassBuilder& pass, PaperTextures& data) {
                if (settings_.lined) data.layer = pass.read(graph.find("line_layer"));
                const gpu::TextureHandle color = graph.find("color");
                const gpu::TextureDesc desc = graph.desc(color);
                data.color = paper.on_shading ? pass.read(color) : pass.write(color);
                data.papered = paper.on_shading ? pass.create("paper_color", desc) : data.color;
                graph.publish("color", data.papered);
                pass.depends_on(version_, paper.strength, paper.pressure, paper.softness, paper.on_lines,
                                paper.on_shading, settings_.bare, rect, render.shaders->generation());
                pass.covers(paper.on_shading ? pixels(desc.width, desc.height) : pixels(rect.width, rect.height));
            },
            [this, &render](const PaperTextures& data, gpu::PassContext& pass) { draw(render, data, pass); });
    }

    static std::uint64_t pixels(int width, int height) {
        return static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height);
    }

    /// Shading goes to another texture than it comes from, and takes the lines with it; lines alone are blended onto
    /// it.
    void draw(RenderContext& render, const PaperTextures& data, gpu::PassContext& pass) {
        const gpu::TextureDesc& desc = pass.desc(data.papered);
        const bool shading = settings_.paper.on_shading;
        render.backend->framebuffer({pass.texture(data.papered)}).bind();
        gpu::DrawState state{.viewport = {0, 0, desc.width, desc.height}, .srgb_write = true};
        if (!shading) {
            state.scissor = settings_.line_rect;
            state.blend = gpu::Blend::premultiplied;
        }
        gpu::apply(state);
        heights_.bind(0);
        if (data.layer) render.backend->texture(pass.texture(data.layer)).bind(1);
        if (shading) render.backend->texture(pass.texture(data.color)).bind(2);
        gpu::Program& program = render.shaders->program(source());
        set_uniforms(program);
        program.use();
        render.full_screen.draw();
    }

    [[nodiscard]] gpu::ProgramSource source() const {
        gpu::ProgramSource source{.vertex = "common/full_screen.vert", .fragment = "paper/paper.frag"};
        if (settings_.lined) source.defines.push_back({"LINES", settings_.paper.on_lines ? "1" : "0"});
        if (settings_.paper.on_shading) source.defines.push_back({"SHADING", ""});
        return source;
    }

    void set_uniforms(gpu::Program& program) const {
        const gpu::Rect& rect = settings_.line_rect;
        program.set("strength", settings_.paper.strength);
        program.set("pressure", settings_.paper.pressure);
        program.set("softness", std::max(settings_.paper.softness, 0.001f));
        program.set("bare", settings_.bare);
        program.set("bare_from", moved(settings_.bare, -rounding));
        program.set("bare_to", moved(settings_.bare, rounding));
        program.set("line_rect", glm::ivec4(rect.x, rect.y, rect.x + rect.width, rect.y + rect.height));
    }

    Settings settings_;
    std::optional<SheetKey> key_; ///< of what `heights_` holds
    gpu::Texture heights_;
    std::uint64_t version_ = 0; ///< another one for each sheet
};

} // namespace

void register_paper(App& app) {
    app.add_component<Paper>();
    if (!app.world().find_resource<LineLayer>()) app.world().set_resource(LineLayer{});
    app.add_system(Stage::render, "paper.pass",
                   [pass = std::make_shared<PaperPass>()](World& world) { pass->declare(world); })
        .after("surface.passes")
        .after("gooch.pass")
        .after("metal.pass")
        .after("toon.pass")
        .after("edge_lines.pass")
        .after("abstracted_lines.pass")
        .after("velocity.pass")
        .after("implicit_brush.pass")
        .after("shade_strokes.pass");
}

} // namespace hachure
