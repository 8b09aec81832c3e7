#pragma once

#include <hachure/components/shade_strokes.h>
#include <hachure/components/shade_volume.h>
#include <hachure/runtime/assets/image.h>
#include <hachure/runtime/scene/mesh_store.h>
#include <hachure/systems/shade_strokes/shade_mesh.h>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <cstdint>
#include <span>
#include <vector>

/// Density that is painted: what makes shade fainter in places. Each function fills `density`, one value per cell in
/// [0, 1], the mean over the cell's area.
namespace hachure {

/// By a channel of the vertex colours; 1 everywhere where the mesh has none.
void density_by_paint(const ShadeMesh& mesh, const SurfaceMesh& surface, ShadePaintChannel channel,
                      std::vector<float>& density);

/// By the brightness of a picture, as its file encodes it, which repeats; 1 everywhere where the mesh has no texture
/// coordinates. A value that is no number counts as 1.
void density_by_picture(const ShadeMesh& mesh, const SurfaceMesh& surface, const assets::Image& picture,
                        std::vector<float>& density);

/// A ShadeVolume where it is in this frame.
struct PlacedVolume {
    ShadeVolume volume;
    glm::mat4 volume_from_world{1.0f};

    /// What shade is multiplied with at a place of the world.
    [[nodiscard]] float factor(const glm::vec3& world) const;

    friend bool operator==(const PlacedVolume&, const PlacedVolume&) = default;
};

/// By volumes, for a surface of those positions (as ShadeLightJob has them) that stands at `world_from_mesh`: at the
/// places where the light is looked at.
void density_by_volumes(const ShadeMesh& mesh, std::span<const glm::vec3> positions,
                        std::span<const std::uint32_t> indices, const glm::mat4& world_from_mesh,
                        std::span<const PlacedVolume> volumes, std::vector<float>& density);

} // namespace hachure
