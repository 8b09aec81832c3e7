#pragma once

#include <hachure/components/shade_strokes.h>
#include <hachure/runtime/gpu/buffer.h>
#include <hachure/runtime/gpu/shader_library.h>
#include <hachure/runtime/gpu/texture.h>
#include <hachure/systems/shade_strokes/shade_buffers.h>

#include <glm/mat4x4.hpp>

#include <cstdint>

namespace hachure {

/// What all surfaces share to draw their strokes: zigzags, and the pattern of triangles of a segment.
struct StrokePatterns {
    StrokePatterns();

    gpu::Buffer zigzags;  ///< ZigzagTables
    gpu::Buffer indices;  ///< of ribbons for a segment's strokes
    gpu::Buffer commands; ///< one per batch, written by the GPU anew for each surface
};

/// Mean coverage of full shade over the component's opacity: how dark strokes get.
inline constexpr float full_darkness = 0.75f;

/// At how many places of a pixel to a side it is known what hides strokes, in pictures of a size: at one each, an edge
/// that moves would take pixels of a stroke at once. 4, and less where that would be more than 2^25 in all (1920x1080
/// has 4) or more than 16384 to a side.
[[nodiscard]] int fine_samples(int width, int height);

/// Draws the strokes of a surface: `find` lets the GPU find out what the view sees of them, `draw` draws that with one
/// indirect call. The uniform block View (ViewUniforms) is bound.
struct ShadeStrokeDraw {
    gpu::ShaderLibrary* shaders = nullptr;
    StrokePatterns* patterns = nullptr;
    ShadeBuffers* buffers = nullptr;        ///< up to date
    const gpu::Buffer* positions = nullptr; ///< floats: xyz of each vertex as deformed, in the mesh's space; from 0 on
    const gpu::Buffer* indices = nullptr;   ///< 3 per triangle, in the order in which the ShadeMesh was made from them
    std::uint32_t triangles = 0;            ///< above 0
    glm::mat4 world_from_mesh{1.0f};        ///< invertible
    float size = 1.0f;                      ///< of the mesh (ShadeMesh::size)
    float hugging = 0.0005f;                ///< over the size: how far the surface may be off (ShadeSettings)
    ShadeStrokes style{};
    int samples = 1;        ///< of depth, in a pixel and to a side: fine_samples()
    std::uint32_t tick = 0; ///< another one whenever flickering strokes jump

    /// Computes where strokes are. Leaves no buffer bound that a draw would mind.
    void find() const;

    /// Draws into the framebuffer that is bound, with its viewport the view's and premultiplied blending; hidden are
    /// strokes behind what `depth` (reversed, `samples` times the view's size) holds. Where `coverage` is true the
    /// framebuffer's second attachment gets the coverage alone.
    void draw(const gpu::Texture& depth, bool coverage) const;

private:
    void place_ribs() const;
    void look_at_segments() const;
    void list_segments() const;
};

} // namespace hachure
