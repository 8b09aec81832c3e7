#pragma once

#include <hachure/runtime/ecs/world.h>
#include <hachure/runtime/gpu/buffer.h>
#include <hachure/runtime/gpu/frame_graph.h>
#include <hachure/runtime/gpu/vertex_array.h>
#include <hachure/runtime/scene/render_context.h>
#include <hachure/systems/abstracted_lines/build_strokes.h>
#include <hachure/systems/abstracted_lines/stroke_batches.h>
#include <hachure/systems/abstracted_lines/stroke_textures.h>

namespace hachure {

/// Declares the passes of strokes: `strokes`, which reads back what was found of lines and makes the world's StrokeSet
/// of it, and `stroke_lines`, which draws onto `line_layer` those of entities that are drawn as strokes.
class StrokePasses {
public:
    void declare(World& world);

private:
    void declare_build(World& world);
    void declare_draw(World& world);
    void draw(World& world, RenderContext& render, const StrokeBatch& batch, const glm::vec3& color);
    void upload();

    StrokeBuilder builder_;
    StrokeTextures textures_;
    StrokeBatches batches_;
    gpu::Buffer buffer_; ///< grows, never shrinks
    gpu::VertexArray vertex_array_;
    bool uploaded_ = false;
};

} // namespace hachure
