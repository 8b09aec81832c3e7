#pragma once

#include <hachure/runtime/ecs/reflect.h>

#include <glm/vec3.hpp>

#include <cstdint>

namespace hachure {

/// What the stripes of metal are counted along; they streak across it.
enum class MetalSource {
    curvature,   ///< the direction in which the surface bends most, on any mesh (docs/metal.md)
    texture_u,   ///< the first texture coordinate
    texture_v,   ///< the second
    around_axis, ///< the angle about an axis of the object, as on a drawn tube
    along_axis,  ///< the place along it: rings, as on a turned part
};

/// What the white stripe faces.
enum class MetalHighlight {
    light,   ///< the light, as Gooch says
    halfway, ///< halfway between the light and the gaze, where a highlight is seen: with Gooch's own light, which
             ///< shines across the gaze, what faces the light itself is the outline
};

/// Milled metal of technical illustration (Gooch et al. 1998, section 4.3): "a set of twenty stripes of varying
/// intensity along the parametric axis of maximum curvature ... random intensities between 0.0 and 0.5 with the stripe
/// closest to the light source direction overwritten with white. Between the stripe centers the colors are linearly
/// interpolated." With `cool_to_warm`, the intensity is the object colour of Gooch's tones (figure 10d); more of it
/// than in matte tones, so that the stripes stand out on the cool side, too.
struct Metal {
    MetalSource source = MetalSource::curvature;
    float sets = 1.0f;
    std::uint32_t count = 20;
    std::uint32_t seed = 9;
    float low = 0.0f;
    float high = 0.5f;
    float light_stripe = 1.0f;
    MetalHighlight highlight = MetalHighlight::halfway;
    float tint = 0.0f;
    float cool_to_warm = 0.0f;
    float b = 0.3f;
    float y = 0.3f;
    float alpha = 0.5f;
    float beta = 0.7f;
    glm::vec3 axis{0.0f, 1.0f, 0.0f};
    glm::vec3 axis_offset{0.0f};
    float detail = 0.1f;
    float crease_angle = 0.6f;

    static constexpr std::uint32_t max_count = 256;

    friend bool operator==(const Metal&, const Metal&) = default;
};

inline void reflect(TypeBuilder<Metal>& type) {
    type.name("metal").doc("stripes of milled metal (Gooch 1998)");
    type.field("source", &Metal::source)
        .doc("what the stripes are counted along: the direction of most curvature, a texture coordinate, the angle "
             "about the axis, or the place along it")
        .options({"curvature", "texture_u", "texture_v", "around_axis", "along_axis"});
    type.field("sets", &Metal::sets)
        .doc("sets of stripes: per half turn of the surface (curvature), unit of texture coordinates, whole turn about "
             "the axis (rounded to a whole number), or length of the object along it")
        .range(0.01, 1000);
    type.field("count", &Metal::count).doc("stripes of a set").range(2, Metal::max_count);
    type.field("seed", &Metal::seed).doc("another one for other stripes").range(0, 4294967295.0);
    type.field("low", &Metal::low).doc("least intensity of a stripe").range(0, 1);
    type.field("high", &Metal::high).doc("greatest intensity of a stripe").range(0, 1);
    type.field("light_stripe", &Metal::light_stripe)
        .doc("how white the stripe is that faces the light; 0 for none")
        .range(0, 1);
    type.field("highlight", &Metal::highlight)
        .doc("what that stripe faces: the light itself, or halfway between it and the gaze, as highlights do")
        .options({"light", "halfway"});
    type.field("tint", &Metal::tint).doc("how much of the material's colour the stripes take").range(0, 1);
    type.field("cool_to_warm", &Metal::cool_to_warm)
        .doc("how far the stripes are shifted from grey to cool and warm tones, whose object colour they are")
        .range(0, 1);
    type.field("b", &Metal::b).doc("blue of the cool tone").range(0, 1);
    type.field("y", &Metal::y).doc("yellow of the warm tone").range(0, 1);
    type.field("alpha", &Metal::alpha).doc("stripes in the cool tone").range(0, 1);
    type.field("beta", &Metal::beta).doc("stripes in the warm tone").range(0, 1);
    type.field("axis", &Metal::axis).doc("direction of the axis, in the object's own space (axis sources)");
    type.field("axis_offset", &Metal::axis_offset)
        .doc("where the axis runs, from the middle of the object's bounds (axis sources)")
        .unit("m");
    type.field("detail", &Metal::detail)
        .doc("least detail whose curvature counts, over the size of each smooth part (curvature)")
        .range(0.001, 0.5);
    type.field("crease_angle", &Metal::crease_angle)
        .doc("angle between hard faces from which their stripes are laid apart (curvature)")
        .unit("rad")
        .range(0, 3.1416);
}

} // namespace hachure
