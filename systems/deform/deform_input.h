#pragma once

#include <hachure/runtime/ecs/entity.h>
#include <hachure/systems/deform/shape_update.h>

#include <glm/vec4.hpp>

#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace hachure {

/// What the GPU makes the shape of one surface from, besides its mesh.
struct DeformInput {
    std::uint32_t mesh = 0;
    std::uint64_t version = 0; ///< of the shape that comes of it
    geometry::SkinMethod method = geometry::SkinMethod::linear;
    std::size_t palette_size = 0; ///< entries; 0 without a skin
    bool morphs = false;          ///< there are weights, and one of them counts
    /// As the shader reads it: the palette, 4 vectors per entry, then the weights of the morph targets, 4 to a vector.
    std::vector<glm::vec4> pose;
};

/// Those of every surface that is deformed on the GPU, whether it is seen or not. A resource: "deform" writes it,
/// "deform.pass" makes the shapes of those that are seen.
struct DeformInputs {
    std::unordered_map<Entity, DeformInput> of;
};

/// What a surface in that state is made from.
[[nodiscard]] DeformInput deform_input(const DeformState& state, std::uint64_t version);

} // namespace hachure
