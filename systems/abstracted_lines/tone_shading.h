#pragma once

#include <hachure/components/abstracted_lines.h>
#include <hachure/components/toon.h>
#include <hachure/runtime/ecs/world.h>
#include <hachure/runtime/gpu/frame_graph_key.h>
#include <hachure/runtime/scene/surface_renderer.h>
#include <hachure/runtime/scene/vertex_textures.h>
#include <hachure/systems/abstracted_lines/mesh_widths.h>
#include <hachure/systems/abstracted_lines/tone_line_frame.h>

namespace hachure {

/// How surfaces are drawn into the tone image: each by its own AbstractedLines, those that have none by defaults, since
/// they hide others and are hidden.
class ToneShading {
public:
    /// Adds what it depends on besides the DrawList, the lights, and the components AbstractedLines and Toon.
    void add_key(const World& world, gpu::KeyHash& key) const;

    /// Draws all surfaces into the framebuffer that is bound.
    void draw(World& world, RenderContext& render, const ToneLineFrame& frame);

private:
    VertexTextures normals_{"abstracted normals of tones"};
    MeshWidths widths_;
    VertexTextures factors_{"widths of lines"};
};

} // namespace hachure
