#pragma once

#include <hachure/runtime/ecs/reflect.h>

namespace hachure {

enum class ShadeVolumeShape {
    sphere, ///< of radius 1
    box,    ///< from -1 to 1 along each axis
};

/// A part of the world that makes shade strokes fainter, in it or around it: what ShadeStrokes ask for by `density_by:
/// volumes`. The entity's transform places, turns and stretches it. Where several volumes overlap, their factors are
/// multiplied.
struct ShadeVolume {
    ShadeVolumeShape shape = ShadeVolumeShape::sphere;
    float inside = 0.0f;
    float outside = 1.0f;
    float falloff = 0.5f;

    friend bool operator==(const ShadeVolume&, const ShadeVolume&) = default;
};

inline void reflect(TypeBuilder<ShadeVolume>& type) {
    type.name("shade_volume").doc("a part of the world that makes shade strokes fainter, in it or around it");
    type.field("shape", &ShadeVolume::shape)
        .doc("what it is, of radius or half side 1 before the entity's transform")
        .options({"sphere", "box"});
    type.field("inside", &ShadeVolume::inside).doc("what shade is multiplied with in its middle").range(0, 1);
    type.field("outside", &ShadeVolume::outside).doc("the same around it").range(0, 1);
    type.field("falloff", &ShadeVolume::falloff)
        .doc("over how much of the way from its border to its middle one becomes the other")
        .range(0, 1);
}

} // namespace hachure
