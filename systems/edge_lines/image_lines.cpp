#include <hachure/runtime/gpu/state.h>
#include <hachure/runtime/scene/view_rects.h>
#include <hachure/systems/edge_lines/image_lines.h>
#include <hachure/systems/edge_lines/line_width.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace hachure {

void ImageLines::clear() {
    styles_.clear();
    rect_ = {};
    widest_ = 0.0f;
    loosest_cosine_ = -2.0f;
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
    loosest_cosine_ = std::max(loosest_cosine_, styles_[item.object_id].crease_cosine);
    widest_ = std::max(widest_, width.by_distance ? static_cast<float>(widest_reach) : half);
    rect_ = united(rect_, grown(item.rect, reach() + 1, view));
}

int ImageLines::reach() const { return std::min(static_cast<int>(std::ceil(widest_)), widest_reach); }

glm::ivec2 ImageLines::grid() const { return (glm::ivec2(rect_.width, rect_.height) + tile_size - 1) / tile_size; }

glm::ivec4 ImageLines::area() const {
    return {rect_.x, rect_.y, rect_.x + rect_.width - 1, rect_.y + rect_.height - 1};
}

ImageLines::Textures ImageLines::declare(gpu::FrameGraph& graph, gpu::PassBuilder& pass, const View& view) const {
    const auto tiles = [](int pixels) { return (pixels + tile_size - 1) / tile_size; };
    return {
        .depth_buffer = pass.read(graph.find("depth_buffer")),
        .code = pass.read(graph.find("surface_code")),
        .tiles = pass.create("line_tiles", {tiles(view.width), tiles(view.height), gpu::Format::r8}),
        .half_widths = pass.create("line_half_widths", {view.width, view.height, gpu::Format::rg16f}),
        .marks = pass.create("line_marks", {view.width, view.height, gpu::Format::rg32ui}),
    };
}

void ImageLines::upload() {
    if (buffer_.bytes() == 0) points_ = gpu::VertexArray("image line tiles");
    const std::size_t bytes = styles_.size() * sizeof(Style);
    if (buffer_.bytes() != bytes) buffer_ = gpu::Buffer(bytes, gpu::BufferUsage::dynamic, "image line styles");
    buffer_.update(std::span<const Style>(styles_));
    buffer_.bind_base(gpu::BufferBinding::storage, 0);
}

void ImageLines::find_tiles(RenderContext& render, gpu::PassContext& pass, const Textures& textures) const {
    gpu::Program& program =
        render.shaders->program({.vertex = "common/full_screen.vert", .fragment = "edge_lines/image_tiles.frag"});
    program.set("area", area());
    program.set("loosest_cosine", loosest_cosine_);
    render.backend->framebuffer({pass.texture(textures.tiles)}).bind();
    render.draw_full_screen("edge_lines/image_tiles.frag", {.viewport = {0, 0, grid().x, grid().y}},
                            {pass.texture(textures.depth_buffer), pass.texture(textures.code)});
}

void ImageLines::draw_tiles(RenderContext& render, gpu::PassContext& pass, const Textures& textures,
                            const char* fragment, int margin) const {
    // The viewport is of whole tiles: a point whose middle is outside of it would not be drawn at all.
    gpu::apply({.viewport = {rect_.x, rect_.y, grid().x * tile_size, grid().y * tile_size},
                .scissor = rect_,
                .program_point_size = true});
    constexpr GLuint tiles_unit = 3;
    render.backend->texture(pass.texture(textures.tiles)).bind(tiles_unit);
    gpu::Program& program = render.shaders->program({.vertex = "edge_lines/image_tiles.vert", .fragment = fragment});
    program.set("grid", grid());
    program.set("margin", margin);
    program.set("area", area());
    program.set("reach", reach());
    program.use();
    points_.bind();
    gpu::gl().DrawArrays(GL_POINTS, 0, grid().x * grid().y);
}

void ImageLines::draw(RenderContext& render, gpu::PassContext& pass, const Textures& textures,
                      gpu::TextureHandle layer) {
    if (rect_.width <= 0 || rect_.height <= 0) return;
    upload();
    find_tiles(render, pass, textures);
    const auto texture = [&](gpu::TextureHandle handle) -> const gpu::Texture& {
        return render.backend->texture(pass.texture(handle));
    };
    const gpu::Framebuffer& marks =
        render.backend->framebuffer({pass.texture(textures.half_widths), pass.texture(textures.marks)});
    marks.bind();
    gpu::apply({.viewport = rect_, .scissor = rect_});
    marks.clear_color(0, std::array{0.0f, 0.0f, 0.0f, 0.0f});
    texture(textures.depth_buffer).bind(0);
    texture(textures.code).bind(1);
    draw_tiles(render, pass, textures, "edge_lines/image_marks.frag", 0);
    render.backend->framebuffer({pass.texture(layer)}).bind();
    texture(textures.half_widths).bind(0);
    texture(textures.marks).bind(1);
    draw_tiles(render, pass, textures, "edge_lines/image_lines.frag", reach());
}

} // namespace hachure
