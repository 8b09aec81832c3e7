#pragma once

#include <hachure/runtime/ecs/entity.h>
#include <hachure/runtime/gpu/texture.h>

#include <glm/vec3.hpp>

#include <cstdint>
#include <span>
#include <string_view>
#include <unordered_map>

namespace hachure {

/// Vectors by vertex that a vertex shader fetches by gl_VertexID, one list per entity, row after row of a texture. By
/// number and not as an attribute: shapes of all kinds, those that the GPU deforms too, are drawn with the vertex
/// arrays that they have.
class VertexTextures {
public:
    static constexpr int columns = 1024;

    /// `label` names the textures in the debugger; it outlives this.
    explicit VertexTextures(std::string_view label) : label_(label) {}

    /// The entity's texture, RGBA32F with alpha 0; made anew when `version` is another one than before. Needs a
    /// context.
    const gpu::Texture& get(Entity entity, std::uint64_t version, std::span<const glm::vec3> values);

    /// Drops those of entities that are not in `kept`.
    void forget_all_but(std::span<const Entity> kept);

private:
    struct Entry {
        gpu::Texture texture;
        std::uint64_t version = 0;
    };
    std::string_view label_;
    std::unordered_map<Entity, Entry> entries_;
};

} // namespace hachure
