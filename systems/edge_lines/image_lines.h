#pragma once

#include <hachure/components/edge_lines.h>
#include <hachure/runtime/gpu/buffer.h>
#include <hachure/runtime/gpu/frame_graph.h>
#include <hachure/runtime/gpu/framebuffer.h>
#include <hachure/runtime/gpu/vertex_array.h>
#include <hachure/runtime/scene/draw_list.h>
#include <hachure/runtime/scene/render_context.h>
#include <hachure/runtime/scene/view.h>

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include <cstdint>
#include <vector>

namespace hachure {

/// Lines from the picture: where depth, object or normal of neighbouring pixels differ. One pass over the pixels that
/// such entities can touch, whatever their meshes, finds the tiles in which they do; in those alone, one pass marks
/// where between two pixels it is, and one draws lines around the marks.
class ImageLines {
public:
    static constexpr int widest_reach = 8; ///< pixels: wider lines are cut off
    static constexpr int tile_size = 8;    ///< pixels; shaders/edge_lines/image_breaks.glsl has the same

    struct Textures {
        gpu::TextureHandle depth_buffer, code, tiles, half_widths, marks;
    };

    void clear();
    void add(const DrawItem& item, const EdgeLines& lines, const View& view);

    [[nodiscard]] bool any() const { return !styles_.empty(); }
    /// Where lines can be.
    [[nodiscard]] const gpu::Rect& rect() const { return rect_; }

    /// Declares what the pass reads and makes.
    [[nodiscard]] Textures declare(gpu::FrameGraph& graph, gpu::PassBuilder& pass, const View& view) const;

    /// Draws the lines into `layer`, which is clear; the view's uniforms are bound.
    void draw(RenderContext& render, gpu::PassContext& pass, const Textures& textures, gpu::TextureHandle layer);

private:
    /// As shaders/edge_lines/image_styles.glsl.
    struct Style {
        glm::vec4 line{0.0f}, crease{0.0f};
        float breaks = 0.0f, crease_cosine = -2.0f;
        glm::vec2 padding{0.0f};
    };
    void upload();
    void find_tiles(RenderContext& render, gpu::PassContext& pass, const Textures& textures) const;
    /// Draws the tiles that were found with a fragment shader, and `margin` pixels around each.
    void draw_tiles(RenderContext& render, gpu::PassContext& pass, const Textures& textures, const char* fragment,
                    int margin) const;
    [[nodiscard]] glm::ivec2 grid() const; ///< tiles that cover rect_
    [[nodiscard]] glm::ivec4 area() const; ///< first and last pixel of rect_
    /// How many pixels away a mark can still be of a line here: marks lie half a pixel off, as rims do.
    [[nodiscard]] int reach() const;

    std::vector<Style> styles_; ///< by object id
    gpu::Rect rect_;
    float widest_ = 0.0f;          ///< half width, pixels
    float loosest_cosine_ = -2.0f; ///< of the least angle that is a crease of some object
    gpu::Buffer buffer_;
    gpu::VertexArray points_; ///< without attributes
};

} // namespace hachure
