#include <hachure/runtime/gpu/frame_graph_key.h>
#include <hachure/runtime/scene/render_context.h>
#include <hachure/runtime/scene/view.h>
#include <hachure/systems/picture/picture_passes.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace hachure {
namespace {

constexpr const char* vertex = "common/full_screen.vert";
constexpr GLuint color_unit = 0, tone_unit = 1;

PictureCoat coat_of(const World& world, Entity entity) {
    const PictureCoat* coat = world.find<PictureCoat>(entity);
    return coat ? *coat : PictureCoat{};
}

bool shows_tone(const PictureCoat& coat) { return coat.show == PictureShow::tone || coat.show == PictureShow::bands; }
bool shows_color(const PictureCoat& coat) {
    return coat.show == PictureShow::picture || (shows_tone(coat) && coat.color > 0.0f);
}

/// Between two colours tones are even to the eye: they are mixed as sRGB encodes them.
glm::vec3 encoded(const glm::vec3& color) {
    glm::vec3 result;
    for (int c = 0; c < 3; ++c)
        result[c] = color[c] <= 0.0031308f ? 12.92f * color[c] : 1.055f * std::pow(color[c], 1.0f / 2.4f) - 0.055f;
    return result;
}

/// Where the picture lies, as shaders/picture/mean.glsl has it.
void set_place(gpu::Program& program, const PictureItem& item, const PictureFile& file) {
    program.set("place", glm::ivec2(item.place.x, item.place.y));
    program.set("texels", glm::vec2(float(file.width()) / float(item.place.width),
                                    float(file.height()) / float(item.place.height)));
}

void set_coat(gpu::Program& program, const PictureCoat& coat) {
    program.set("bands", coat.bands);
    program.set("softness", coat.softness);
    program.set("smoothing", coat.smoothing);
    program.set("own_color", coat.color);
    program.set("light", encoded(coat.light));
    program.set("shade", encoded(coat.shade));
}

/// The texture that others read a layer from.
struct LayerTexture {
    const char* name;
    gpu::Format format;
    std::array<float, 4> nothing; ///< beside pictures, and where one lacks the layer
    const char* fragment;
    gpu::Blend blend;
};

constexpr std::array<LayerTexture, 4> layer_textures{{
    {"picture_tone", gpu::Format::rg32f, {1.0f, 0.0f, 0.0f, 0.0f}, "picture/mean.frag", gpu::Blend::off},
    {"picture_color", gpu::Format::rgba16f, {}, "picture/mean.frag", gpu::Blend::premultiplied},
    {"picture_normal", gpu::Format::rgba32f, {}, "picture/nearest.frag", gpu::Blend::off},
    {"picture_depth", gpu::Format::r32f, {assets::no_depth, 0.0f, 0.0f, 0.0f}, "picture/nearest.frag", gpu::Blend::off},
}};

constexpr std::size_t index_of(PictureLayer layer) { return static_cast<std::size_t>(layer); }

bool has(const PictureItem& item, PictureLayer layer) {
    return layer == PictureLayer::normal ? item.has_normal : layer != PictureLayer::depth || item.has_depth;
}

struct BasePass {
    gpu::TextureHandle color, depth_buffer, object_id, code;
};

BasePass write_targets(gpu::FrameGraph& graph, gpu::PassBuilder& pass) {
    const auto write = [&](std::string_view name) {
        gpu::TextureHandle handle = graph.find(name);
        if (!handle) return handle;
        handle = pass.write(handle);
        graph.publish(name, handle);
        return handle;
    };
    return {write("color"), write("depth_buffer"), write("object_id"), write("surface_code")};
}

std::vector<gpu::ShaderDefine> base_defines(const PictureCoat& coat, const BasePass& data) {
    std::vector<gpu::ShaderDefine> defines{{"SHOW", std::to_string(static_cast<int>(coat.show))}};
    if (shows_tone(coat) && shows_color(coat)) defines.push_back({"OWN_COLOR", ""});
    if (data.object_id) defines.push_back({"OUT_OBJECT_ID", ""});
    if (data.code) defines.push_back({"OUT_CODE", ""});
    return defines;
}

} // namespace

void PicturePasses::declare(World& world) {
    const PictureList& list = world.resource<PictureList>();
    textures_.forget_all_but(list);
    if (list.items.empty()) return;
    const FrameRequests& requests = world.resource<FrameRequests>();
    PictureLayers wanted{};
    for (std::size_t i = 0; i < wanted.size(); ++i) wanted[i] = requests.wants(layer_textures[i].name);
    for (const PictureItem& item : list.items) {
        const PictureCoat coat = coat_of(world, item.entity);
        PictureLayers of_item = wanted;
        of_item[index_of(PictureLayer::tone)] |= shows_tone(coat);
        of_item[index_of(PictureLayer::color)] |= shows_color(coat);
        textures_.want(item, of_item);
    }
    declare_base(world);
    for (std::size_t i = 0; i < wanted.size(); ++i)
        if (wanted[i]) declare_layer(world, static_cast<PictureLayer>(i));
}

/// Behind the surfaces: only where the depth is still that of the far plane, which is where a full-screen triangle
/// lies.
void PicturePasses::declare_base(World& world) {
    RenderContext& render = world.resource_mutable<RenderContext>();
    gpu::FrameGraph& graph = render.graph;
    graph.add_pass<BasePass>(
        "picture",
        [&](gpu::PassBuilder& pass, BasePass& data) {
            data = write_targets(graph, pass);
            pass.depends_on(world.resource<PictureList>().key, world.last_changed<PictureCoat>(),
                            render.shaders->generation());
        },
        [this, &world, &render](const BasePass& data, gpu::PassContext& pass) {
            const View& view = world.resource<View>();
            const auto id = [&](gpu::TextureHandle handle) { return handle ? pass.texture(handle) : 0u; };
            render.backend
                ->framebuffer({pass.texture(data.color), 0u, id(data.object_id), id(data.code)},
                              pass.texture(data.depth_buffer))
                .bind();
            for (const PictureItem& item : world.resource<PictureList>().items) {
                const PictureCoat coat = coat_of(world, item.entity);
                PictureFile& file = world.resource_mutable<PictureFiles>().files.at(item.entity);
                gpu::Program& program = render.shaders->program(
                    {.vertex = vertex, .fragment = "picture/picture.frag", .defines = base_defines(coat, data)});
                set_place(program, item, file);
                set_coat(program, coat);
                program.set("object_id", item.object_id);
                if (shows_color(coat))
                    textures_.texture(PictureLayer::color, *render.context, file, item).bind(color_unit);
                if (shows_tone(coat))
                    textures_.texture(PictureLayer::tone, *render.context, file, item).bind(tone_unit);
                gpu::apply({.viewport = {0, 0, view.width, view.height},
                            .scissor = item.rect,
                            .depth_test = gpu::DepthTest::equal,
                            .blend = gpu::Blend::premultiplied,
                            .srgb_write = true});
                program.use();
                render.full_screen.draw();
            }
        });
}

void PicturePasses::declare_layer(World& world, PictureLayer layer) {
    struct Data {
        gpu::TextureHandle texture;
    };
    RenderContext& render = world.resource_mutable<RenderContext>();
    const View& view = world.resource<View>();
    const LayerTexture& made = layer_textures[index_of(layer)];
    render.graph.add_pass<Data>(
        made.name,
        [&](gpu::PassBuilder& pass, Data& data) {
            data.texture = pass.create(made.name, {view.width, view.height, made.format});
            render.graph.publish(made.name, data.texture);
            pass.depends_on(world.resource<PictureList>().key, render.shaders->generation());
        },
        [this, &world, &render, &made, layer](const Data& data, gpu::PassContext& pass) {
            const gpu::TextureDesc& desc = pass.desc(data.texture);
            const gpu::Rect viewport{0, 0, desc.width, desc.height};
            const gpu::Framebuffer& framebuffer = render.backend->framebuffer({pass.texture(data.texture)});
            framebuffer.bind();
            gpu::apply({.viewport = viewport});
            framebuffer.clear_color(0, made.nothing);
            gpu::Program& program =
                render.shaders->program({.vertex = vertex, .fragment = made.fragment, .defines = {}});
            for (const PictureItem& item : world.resource<PictureList>().items) {
                gpu::apply({.viewport = viewport, .scissor = item.rect, .blend = made.blend});
                if (!has(item, layer)) {
                    framebuffer.clear_color(0, made.nothing);
                    continue;
                }
                PictureFile& file = world.resource_mutable<PictureFiles>().files.at(item.entity);
                textures_.texture(layer, *render.context, file, item).bind(0);
                set_place(program, item, file);
                program.use();
                render.full_screen.draw();
            }
        });
}

} // namespace hachure
