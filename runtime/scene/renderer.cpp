#include <hachure/runtime/assert.h>
#include <hachure/runtime/error.h>
#include <hachure/runtime/scene/render_context.h>
#include <hachure/runtime/scene/renderer.h>

#include <algorithm>

namespace hachure {
namespace {

/// What holds for everything the house draws: depth is reversed, in [0, 1].
void set_conventions() { gpu::gl().ClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE); }

std::string known_names(const FrameRequests& requests) {
    std::string names;
    for (const AovInfo& aov : requests.known) names += (names.empty() ? "" : ", ") + aov.name;
    return names;
}

} // namespace

Renderer::Renderer(App& app, gpu::Context& context) : app_(&app) {
    set_conventions();
    app.world().set_resource(RenderContext(context));
    static_cast<void>(frame_requests(app.world()));
}

Renderer::~Renderer() { app_->world().remove_resource<RenderContext>(); }

void Renderer::request_aov(std::string_view name) {
    FrameRequests& requests = app_->world().resource_mutable<FrameRequests>();
    if (std::ranges::find(requests.known, name, &AovInfo::name) == requests.known.end())
        throw Error(name, "there is no such AOV; there are " + known_names(requests));
    requests.aovs.emplace(name);
}

void Renderer::declare_frame(double delta_seconds) {
    RenderContext& render = app_->world().resource_mutable<RenderContext>();
    app_->world().resource_mutable<FrameRequests>().textures.clear();
    render.shaders->reload_changed();
    render.graph.begin_frame();
    app_->run_frame(delta_seconds);
}

void Renderer::skip_frame(double delta_seconds) { declare_frame(delta_seconds); }

void Renderer::render_frame(double delta_seconds) {
    declare_frame(delta_seconds);
    RenderContext& render = app_->world().resource_mutable<RenderContext>();
    const FrameRequests& requests = app_->world().resource<FrameRequests>();
    for (const std::string& name : requests.aovs) {
        const gpu::TextureHandle texture = render.graph.find(name);
        if (!texture) throw Error(name, "no system of this scene makes this AOV");
        render.graph.require(texture);
    }
    if (const gpu::TextureHandle picture = render.graph.find("picture")) render.graph.require(picture);
    render.graph.run();
}

assets::Image Renderer::read_picture() {
    RenderContext& render = app_->world().resource_mutable<RenderContext>();
    const gpu::Texture& texture = render.backend->texture(render.graph.texture(render.graph.find("picture")));
    assets::Image image = assets::make_image(texture.width(), texture.height(), 3, assets::PixelType::u8);
    const std::vector<std::uint8_t> rgba = texture.read_bytes();
    for (std::size_t i = 0; i < rgba.size() / 4; ++i) std::copy_n(rgba.data() + 4 * i, 3, image.u8() + 3 * i);
    return image;
}

assets::Image Renderer::read_aov(std::string_view name) {
    RenderContext& render = app_->world().resource_mutable<RenderContext>();
    const FrameRequests& requests = app_->world().resource<FrameRequests>();
    HACHURE_ASSERT(requests.aovs.contains(name), "an AOV is requested before the frame that it is read from");
    const auto info = std::ranges::find(requests.known, name, &AovInfo::name);
    const int channels = static_cast<int>(info->channel_names.size());
    const gpu::Texture& texture = render.backend->texture(render.graph.texture(render.graph.find(name)));
    assets::Image image = assets::make_image(texture.width(), texture.height(), channels, assets::PixelType::f32);
    const std::size_t pixels = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
    if (texture.desc().format == gpu::Format::r32ui) {
        const std::vector<std::uint32_t> ids = texture.read_uints();
        std::ranges::transform(ids, image.f32(), [](std::uint32_t id) { return static_cast<float>(id); });
        return image;
    }
    const std::vector<float> values = texture.read_floats();
    const std::size_t stride = static_cast<std::size_t>(texture.channels());
    for (std::size_t i = 0; i < pixels; ++i)
        std::copy_n(values.data() + stride * i, channels, image.f32() + static_cast<std::size_t>(channels) * i);
    return image;
}

void Renderer::present() {
    RenderContext& render = app_->world().resource_mutable<RenderContext>();
    const std::uint32_t picture = render.graph.texture(render.graph.find("picture"));
    const gpu::Framebuffer& framebuffer = render.backend->framebuffer({picture});
    gpu::apply({.viewport = {0, 0, framebuffer.width(), framebuffer.height()}});
    framebuffer.blit_to_window({0, 0, framebuffer.width(), framebuffer.height()});
    render.context->swap_buffers();
}

std::span<const gpu::PassStats> Renderer::pass_stats() {
    RenderContext& render = app_->world().resource_mutable<RenderContext>();
    render.graph.finish();
    return render.graph.stats();
}

gpu::FrameGraphMemory Renderer::memory() const { return app_->world().resource<RenderContext>().graph.memory(); }

void Renderer::finish() { gpu::gl().Finish(); }

} // namespace hachure
