#pragma once

#include <hachure/runtime/ecs/entity.h>
#include <hachure/runtime/ecs/world.h>
#include <hachure/runtime/gpu/buffer.h>
#include <hachure/runtime/scene/render_context.h>
#include <hachure/systems/shade_strokes/shade_buffers.h>
#include <hachure/systems/shade_strokes/shade_draw.h>
#include <hachure/systems/shade_strokes/shade_frame.h>

#include <cstdint>
#include <optional>
#include <unordered_map>

namespace hachure {

/// Declares the pass `shade_strokes`, which draws the strokes of ShadeFrame onto `line_layer` and, where someone wants
/// it, their coverage alone into the texture `shade_coverage` (r16f).
class ShadePasses {
public:
    void declare(World& world);

    /// What was written to the buffers of all surfaces that are drawn now, since each was first drawn.
    [[nodiscard]] ShadeUploads uploads() const;

private:
    void draw(World& world, const gpu::Texture& depth, bool coverage);
    [[nodiscard]] const gpu::Buffer& indices_of(const World& world, std::uint32_t mesh);
    void forget_all_but(const ShadeFrame& frame);

    std::optional<StrokePatterns> patterns_; ///< made when first drawn: there is a context then
    std::unordered_map<Entity, ShadeBuffers> buffers_;
    std::unordered_map<std::uint32_t, gpu::Buffer> indices_; ///< by mesh, in the mesh's own order
};

} // namespace hachure
