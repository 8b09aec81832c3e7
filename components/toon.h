#pragma once

#include <hachure/runtime/ecs/reflect.h>

#include <glm/vec3.hpp>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace hachure {

/// What tones do with the material's colour.
enum class RampUse { multiply, replace };

/// What the tone detail D of X-Toon follows (Barla et al. 2006, section 3). Detail is 1 where all is drawn, and 0 where
/// all is abstracted away.
enum class ToonDetail {
    none,           ///< D = 1
    depth,          ///< D = 1 - log(z / z_min) / log(r), z the distance from the eye, z_min `detail_distance`
    depth_of_field, ///< D = 1 - |log(z / z_c)| / log(r), z along the gaze, z_c `detail_distance`
    focus,          ///< as depth, with z the distance from `focus`
    orientation,    ///< D = |n.v|^s: falls towards silhouettes
    highlight,      ///< D = |v.r|^s, r the strongest light mirrored: rises where it shines
};

/// The simple shape whose normals a surface takes instead of its own (Barla et al. 2006, section 4).
enum class AbstractedShape { smoothed, ellipsoid, sphere, cylinder };

/// Cel shading: the light that a surface receives, summed over all lights, is cut into a few flat tones. Without
/// shadows that objects cast, as in Barla et al. 2006. docs/toon.md has the model. Colours are linear RGB.
struct Toon {
    std::int32_t bands = 3;
    float wrap = 0.5f;
    float dark_edge = 0.1f;
    float light_edge = 0.37f;
    float softness = 0.0f;
    glm::vec3 light{1.0f};
    glm::vec3 shade{0.36f, 0.33f, 0.52f};

    std::string ramp;
    RampUse ramp_use = RampUse::multiply;

    ToonDetail detail = ToonDetail::none;
    float detail_distance = 1.0f;
    float detail_ratio = 10.0f;
    float detail_power = 2.0f;
    Entity focus = Entity::null;
    glm::vec3 focus_point{0.0f};

    float rim = 0.0f;
    float rim_width = 0.3f;
    bool rim_lit_only = true;
    glm::vec3 rim_color{1.0f};

    float specular = 0.0f;
    float specular_size = 0.25f;
    glm::vec3 specular_color{1.0f};

    float abstraction = 0.0f;
    AbstractedShape abstracted_shape = AbstractedShape::smoothed;
    float abstraction_radius = 0.1f;

    friend bool operator==(const Toon&, const Toon&) = default;
};

inline void reflect(TypeBuilder<Toon>& type) {
    type.name("toon").doc("cel shading: light cut into flat tones, with X-Toon's detail (Barla 2006)");
    type.field("bands", &Toon::bands).doc("how many tones from shade to light").range(1, 16);
    type.field("wrap", &Toon::wrap)
        .doc("how far light reaches round: it ends where the cosine to the light is -wrap")
        .range(0, 1);
    type.field("dark_edge", &Toon::dark_edge)
        .doc("light below which the darkest tone lies; 1 is that of one light straight on")
        .range(0, 1);
    type.field("light_edge", &Toon::light_edge)
        .doc("light from which on the lightest does; edges between are spaced evenly, and one alone is in the middle")
        .range(0, 1);
    type.field("softness", &Toon::softness)
        .doc("width of the change from a tone to the next, as a part of the whole scale; 0 for a sharp one")
        .range(0, 1);
    type.field("light", &Toon::light).color().doc("multiplies the material's colour in the lightest tone");
    type.field("shade", &Toon::shade).color().doc("multiplies it in the darkest; tones between are spaced evenly");
    type.field("ramp", &Toon::ramp)
        .doc(
            "picture with the tones in place of bands, light and shade: from dark at the left to light; the top row is "
            "for full detail, the bottom row for none")
        .unit("image file");
    type.field("ramp_use", &Toon::ramp_use)
        .doc("the ramp, or light and shade where there is none, multiply the material's colour, or replace it")
        .options({"multiply", "replace"});
    type.field("detail", &Toon::detail)
        .doc("what the detail of tones follows: with less, tones merge and shade fades, or lower rows of the ramp show")
        .options({"none", "depth", "depth_of_field", "focus", "orientation", "highlight"});
    type.field("detail_distance", &Toon::detail_distance)
        .doc("distance up to which detail is full (depth, focus), or at which (depth_of_field)")
        .unit("m")
        .range(1e-6, 1e9);
    type.field("detail_ratio", &Toon::detail_ratio).doc("how many times as far there is none left").range(1.001, 1e6);
    type.field("detail_power", &Toon::detail_power).doc("exponent of orientation and highlight").range(0, 1000);
    type.field("focus", &Toon::focus).doc("entity from which distances are measured (focus); null for focus_point");
    type.field("focus_point", &Toon::focus_point).doc("place from which they are, in the world").unit("m");
    type.field("rim", &Toon::rim).doc("strength of the band along silhouettes; 0 for none").range(0, 1);
    type.field("rim_width", &Toon::rim_width)
        .doc("where the band begins: where the cosine to the eye is below")
        .range(0, 1);
    type.field("rim_lit_only", &Toon::rim_lit_only).doc("the band ends where the darkest tone begins");
    type.field("rim_color", &Toon::rim_color).color().doc("colour of the band");
    type.field("specular", &Toon::specular).doc("strength of highlights with a sharp edge; 0 for none").range(0, 1);
    type.field("specular_size", &Toon::specular_size)
        .doc("angle between normal and half vector at the edge of a highlight")
        .unit("rad")
        .range(0.001, 1.5);
    type.field("specular_color", &Toon::specular_color).color().doc("colour of highlights");
    type.field("abstraction", &Toon::abstraction)
        .doc("how far normals for shading move from the surface's own to those of the abstracted shape")
        .range(0, 1);
    type.field("abstracted_shape", &Toon::abstracted_shape)
        .doc("the surface smoothed, or what is fitted to its vertices")
        .options({"smoothed", "ellipsoid", "sphere", "cylinder"});
    type.field("abstraction_radius", &Toon::abstraction_radius)
        .doc("how far smoothing reaches, relative to the radius of the surface")
        .range(0.001, 10);
}

/// The normals of the abstracted shape, of a surface whose Toon asks for them; systems/toon computes them.
struct AbstractedNormals {
    std::shared_ptr<const std::vector<glm::vec3>> normals; ///< unit, by vertex of the mesh, in entity space
    std::uint64_t version = 0;                             ///< another one whenever they are others
};

} // namespace hachure
