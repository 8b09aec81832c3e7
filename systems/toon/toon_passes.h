#pragma once

#include <hachure/components/toon.h>
#include <hachure/runtime/ecs/world.h>
#include <hachure/runtime/gpu/program.h>
#include <hachure/runtime/scene/vertex_textures.h>
#include <hachure/systems/toon/toon_ramps.h>

#include <string_view>
#include <vector>

namespace hachure {

struct DrawItem;
struct RenderContext;

/// Draws the items that "toon" has claimed, and keeps what that needs on the GPU: ramps and abstracted normals.
class ToonPasses {
public:
    static constexpr std::string_view name = "toon";

    /// Throws Error for a ramp that can't be read.
    void declare(World& world);

private:
    void read_ramps(const World& world, const std::vector<Entity>& drawn);
    void bind(const World& world, const DrawItem& item);

    ToonRamps ramps_;
    VertexTextures normals_{"abstracted normals"};
};

} // namespace hachure
