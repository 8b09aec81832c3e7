#pragma once

#include <hachure/components/edge_lines.h>
#include <hachure/runtime/gpu/buffer.h>
#include <hachure/runtime/gpu/frame_graph.h>
#include <hachure/runtime/gpu/framebuffer.h>
#include <hachure/runtime/scene/draw_list.h>
#include <hachure/runtime/scene/render_context.h>
#include <hachure/runtime/scene/view.h>

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include <cstdint>
#include <vector>

namespace hachure {

/// Lines from the picture: where depth, object or normal of neighbouring pixels differ. Two passes over the pixels that
/// such entities can touch, whatever their meshes: marks between pixels, and lines around the marks.
class ImageLines {
public:
    static constexpr int widest_reach = 8; ///< pixels: wider lines are cut off

    struct Textures {
        gpu::TextureHandle depth_buffer, normal, object_id, marks;
    };

    void clear();
    void add(const DrawItem& item, const EdgeLines& lines, const View& view);

    [[nodiscard]] bool any() const { return !styles_.empty(); }
    /// Where lines can be.
    [[nodiscard]] const gpu::Rect& rect() const { return rect_; }

    /// Declares what the pass reads and makes.
    [[nodiscard]] Textures declare(gpu::FrameGraph& graph, gpu::PassBuilder& pass, const View& view) const;

    /// Lays the lines over `layer`; the view's uniforms are bound.
    void draw(RenderContext& render, gpu::PassContext& pass, const Textures& textures, gpu::TextureHandle layer);

private:
    /// As shaders/edge_lines/image_styles.glsl.
    struct Style {
        glm::vec4 line{0.0f}, crease{0.0f};
        float breaks = 0.0f, crease_cosine = -2.0f;
        glm::vec2 padding{0.0f};
    };
    void upload();
    /// How many pixels away a mark can still be of a line here: marks lie half a pixel off, as rims do.
    [[nodiscard]] int reach() const;

    std::vector<Style> styles_; ///< by object id
    gpu::Rect rect_;
    float widest_ = 0.0f; ///< half width, pixels
    gpu::Buffer buffer_;
};

} // namespace hachure
