#include <hachure/runtime/gpu/state.h>
#include <hachure/systems/edge_lines/image_lines.h>
#include <hachure/systems/edge_lines/line_rects.h>
#include <hachure/systems/edge_lines/line_width.h>

#include <algorithm>
#include <cmath>

namespace hachure {

void ImageLines::clear() {
    styles_.clear();
    rect_ = {};
    widest_ = 0.0f;
}

void ImageLines::add(const DrawItem& item, const EdgeLines& lines, const View& view) {
    const LineWidth width = width_on_screen(lines, view);
    const auto half = static_cast<float>(width.half_width);
    if (styles_.size() <= item.object_id) styles_.resize(item.object_id + 1);
    const bool crease_is_light = lines.crease_highlight;
    const glm::vec3 crease = crease_is_light       ? lines.highlight_color
                             : lines.color_by_kind ? lines.crease_color
                                                   : lines.color;
    styles_[item.object_id] = {.line = glm::vec4(lines.color, width.by_distance ? -half : half),
                               .crease = glm::vec4(crease, 0.0f),
                               .breaks = lines.silhouette || lines.border ? 1.0f : 0.0f,
                               .crease_cosine = lines.crease ? std::cos(lines.crease_angle) : -2.0f};
    widest_ = std::max(widest_, width.by_distance ? static_cast<float>(widest_reach) : half);
    rect_ = united(rect_, grown(item.rect, reach() + 1, view));
}

int ImageLines::reach() const { return std::min(static_cast<int>(std::ceil(widest_)), widest_reach); }

ImageLines::Textures ImageLines::declare(gpu::FrameGraph& graph, gpu::PassBuilder& pass, const View& view) const {
    return {.depth_buffer = pass.read(graph.find("depth_buffer")),
            .normal = pass.read(graph.find("normal")),
            .object_id = pass.read(graph.find("object_id")),
            .marks = pass.create("line_marks", {view.width, view.height, gpu::Format::rg32ui})};
}

void ImageLines::upload() {
    const std::size_t bytes = styles_.size() * sizeof(Style);
    if (buffer_.bytes() != bytes) buffer_ = gpu::Buffer(bytes, gpu::BufferUsage::dynamic, "image line styles");
    buffer_.update(std::span<const Style>(styles_));
    buffer_.bind_base(gpu::BufferBinding::storage, 0);
}

void ImageLines::draw(RenderContext& render, gpu::PassContext& pass, const Textures& textures,
                      gpu::TextureHandle layer) {
    upload();
    const gpu::TextureDesc& desc = pass.desc(layer);
    gpu::DrawState state{.viewport = {0, 0, desc.width, desc.height}, .scissor = rect_};
    render.backend->framebuffer({pass.texture(textures.marks)}).bind();
    render.draw_full_screen(
        "edge_lines/image_marks.frag", state,
        {pass.texture(textures.depth_buffer), pass.texture(textures.normal), pass.texture(textures.object_id)});
    render.backend->framebuffer({pass.texture(layer)}).bind();
    state.blend = gpu::Blend::premultiplied;
    gpu::Program& program =
        render.shaders->program({.vertex = "common/full_screen.vert", .fragment = "edge_lines/image_lines.frag"});
    program.set("reach", reach());
    render.draw_full_screen("edge_lines/image_lines.frag", state,
                            {pass.texture(textures.marks), pass.texture(textures.depth_buffer)});
}

} // namespace hachure
