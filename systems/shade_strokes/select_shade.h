#pragma once

#include <hachure/components/curvature.h>
#include <hachure/components/shade_strokes.h>
#include <hachure/components/shade_volume.h>
#include <hachure/components/world_transform.h>
#include <hachure/runtime/assets/image.h>
#include <hachure/runtime/ecs/schedule.h>
#include <hachure/runtime/ecs/time.h>
#include <hachure/runtime/scene/draw_list.h>
#include <hachure/runtime/scene/light_list.h>
#include <hachure/runtime/scene/light_strength.h>
#include <hachure/runtime/scene/line_layer.h>
#include <hachure/runtime/scene/mesh_store.h>
#include <hachure/runtime/scene/view.h>
#include <hachure/systems/shade_strokes/kept_shade.h>
#include <hachure/systems/shade_strokes/shade_aovs.h>
#include <hachure/systems/shade_strokes/shade_counts.h>
#include <hachure/systems/shade_strokes/shade_frame.h>
#include <hachure/systems/shade_strokes/shade_meshes.h>

#include <map>
#include <memory>
#include <string>
#include <unordered_map>
#include <vector>

namespace hachure {

/// Those with strokes; where they carry a Curvature, too, amplitudes follow it.
using StyledSurfaces = Query<const ShadeStrokes, Optional<const Curvature>, Optional<const PrincipalCurvatures>>;

/// The system that keeps the strokes of all surfaces: it finds those in view that carry ShadeStrokes, brings their
/// strokes to what the lights of this frame need, and fills in the ShadeFrame and what belongs to it. Strokes of
/// surfaces out of view are kept as they are, and go with the component. A frame without ShadeStrokes allocates
/// nothing.
class SelectShade {
public:
    void operator()(StyledSurfaces styled, Removed<ShadeStrokes> bare,
                    Query<const ShadeVolume, const WorldTransform> volumes, const DrawList& list,
                    const MeshStore& store, const LightList& lights, const LightStrength& strength, const View& view,
                    const Time& time, ShadeFrame& frame, ShadeNeeds& needs, ShadeCounts& counts, LineLayer& layer);

private:
    /// A surface of this frame.
    struct Shaded {
        std::size_t item;
        const ShadeStrokes* style;
        const Curvature* curvature_asked;
        const PrincipalCurvatures* curvature;
        KeptShade* kept;
    };

    void find_surfaces(const StyledSurfaces& styled, const DrawList& list, const MeshStore& store);
    void place_volumes(const Query<const ShadeVolume, const WorldTransform>& volumes);
    void step(const DrawList& list, const MeshStore& store, const LightList& lights, float strongest, const View& view);
    void count(const DrawList& list, const MeshStore& store, ShadeCounts& counts) const;
    void fill(const DrawList& list, const View& view, ShadeFrame& frame) const;
    void fill_needs(const DrawList& list, ShadeNeeds& needs) const;
    const assets::Image* picture_of(const ShadeStrokes& style);
    void warn_of_lights();

    ShadeMeshes meshes_;
    std::unordered_map<Entity, std::unique_ptr<KeptShade>> kept_;
    std::map<std::string, assets::Image> pictures_; ///< by file
    std::vector<Shaded> shaded_;                    ///< in the order of the DrawList
    std::vector<PlacedVolume> volumes_;             ///< in the order of their entities
    std::vector<ShadeInput> inputs_;                ///< scratch
    bool warned_ = false;
};

} // namespace hachure
