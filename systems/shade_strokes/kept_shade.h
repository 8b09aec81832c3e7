#pragma once

#include <hachure/components/curvature.h>
#include <hachure/components/shade_strokes.h>
#include <hachure/runtime/scene/draw_list.h>
#include <hachure/runtime/scene/light_list.h>
#include <hachure/runtime/scene/mesh_store.h>
#include <hachure/systems/shade_strokes/shade_density.h>
#include <hachure/systems/shade_strokes/shade_light.h>
#include <hachure/systems/shade_strokes/shade_meshes.h>
#include <hachure/systems/shade_strokes/shade_narrowing.h>
#include <hachure/systems/shade_strokes/shade_update.h>

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace hachure {

/// What the shade of one surface follows from in this frame.
struct ShadeInput {
    const DrawItem* item = nullptr;
    const SurfaceMesh* surface = nullptr;
    const ShadeStrokes* style = nullptr;
    std::shared_ptr<const SharedShadeMesh> mesh;
    std::span<const ShadingLight> lights;
    float strongest = 1.0f; ///< as LightStrength has it
    ShadeEye eye;
    const assets::Image* picture = nullptr; ///< that paints density; null where none does
    std::span<const PlacedVolume> volumes;  ///< likewise
    const Curvature* asked = nullptr;       ///< by what amplitudes are to follow the deformed surface; null: not at all
    const PrincipalCurvatures* curvature = nullptr; ///< that came of it; null where nothing has yet
};

/// The strokes of one entity, kept from frame to frame with all that brings them up to date. Entities are independent
/// of each other: several may be brought up to date at a time.
class KeptShade {
public:
    /// Brings needed shade and strokes to what the frame wants. What did not change since the last call costs nothing;
    /// after the first ones it allocates for new strokes alone.
    void step(const ShadeInput& input);

    [[nodiscard]] const ShadeMesh& mesh() const { return mesh_->mesh; }
    [[nodiscard]] ShadeChains& chains() { return chains_; }
    [[nodiscard]] const ShadeChains& chains() const { return chains_; }
    [[nodiscard]] std::span<const float> needed() const { return needed_; }                 ///< per cell
    [[nodiscard]] std::span<const glm::vec3> positions() const { return light_.positions; } ///< of the last step
    /// How much of their amplitude strokes keep, per vertex of the mesh; none where all of it. Another version whenever
    /// it is another.
    [[nodiscard]] std::span<const float> narrowing() const { return update_.narrowing.shares; }
    [[nodiscard]] std::uint64_t narrowing_version() const { return narrowing_version_; }
    /// Another number whenever strokes are others.
    [[nodiscard]] std::uint64_t version() const { return version_; }
    /// Another number whenever needs may be.
    [[nodiscard]] std::uint64_t needed_version() const { return needed_version_; }

    // Of the last step.
    [[nodiscard]] bool swept() const { return light_.swept; }
    [[nodiscard]] const ShadeUpdateStats& stats() const { return update_.stats; }
    [[nodiscard]] std::uint64_t triangles_touched() const;
    [[nodiscard]] std::size_t ignored_lights() const { return light_.ignored_lights; }

private:
    void take_shape(const ShadeInput& input);
    void take_density(const ShadeInput& input);
    void take_curvature(const ShadeInput& input, const ShadeSettings& settings);
    void paint(const ShadeInput& input);
    void update_strokes(const ShadeSettings& settings);

    std::shared_ptr<const SharedShadeMesh> mesh_;
    ShadeLightJob light_;
    ShadeNarrowingJob narrowing_;
    ShadeUpdateJob update_;
    ShadeChains chains_;
    std::vector<float> needed_;       ///< per cell
    std::vector<float> density_;      ///< per cell; empty where nothing paints any
    std::uint64_t density_key_ = 0;   ///< of what density was painted from
    std::uint64_t narrowing_key_ = 0; ///< of what the narrowing was found from; 0: none
    std::uint64_t version_ = 0, needed_version_ = 0, narrowing_version_ = 0;
};

} // namespace hachure
