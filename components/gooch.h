#pragma once

#include <hachure/runtime/ecs/reflect.h>

namespace hachure {

/// How a surface with Gooch is lit. The per-vertex modes are lit at the vertices, without a normal map's relief, and
/// interpolated.
enum class GoochShading {
    tone,                  ///< the model itself (section 4.2)
    two_lights,            ///< its approximation with Phong's model: lights from l and -l, no highlight (section 4.4)
    two_lights_per_vertex, ///< the same on a pipeline that lights vertices, as those of 1998 did
    phong,                 ///< what it is compared with: equation 1 with Phong's highlight
    phong_per_vertex,
};

/// Whose fields hold for a surface.
enum class GoochParameters {
    own,   ///< those of its own Gooch
    scene, ///< those of the Gooch of the camera that draws the view; its own where the camera has none
};

/// Cool-to-warm tone shading of technical illustration (Gooch et al. 1998, section 4.2). Colours are linear RGB:
///
///     k_cool = (0, 0, b) + alpha k_d        k_warm = (y, y, 0) + beta k_d        (equation 3)
///     I = (1 - w) k_cool + w k_warm,        w = (1 + l.n) / 2                    (equation 2, see printed_equation)
///
/// and a Phong highlight of the light's colour, white by default, is laid over it. The defaults are figure 7's. On a
/// camera it draws nothing: it is what surfaces with `parameters` scene follow. docs/gooch.md: several lights, errors.
struct Gooch {
    GoochShading shading = GoochShading::tone;
    GoochParameters parameters = GoochParameters::own;
    float b = 0.4f;
    float y = 0.4f;
    float alpha = 0.2f;
    float beta = 0.6f;
    float highlight = 0.8f;
    float shininess = 40.0f;
    bool printed_equation = false;
    bool clamp_lights = false;
    float ambient = 0.1f;
    float diffuse = 1.0f;

    friend bool operator==(const Gooch&, const Gooch&) = default;
};

inline void reflect(TypeBuilder<Gooch>& type) {
    type.name("gooch").doc(
        "cool-to-warm tone shading (Gooch 1998); on a camera, what surfaces with parameters 'scene' follow");
    type.field("shading", &Gooch::shading)
        .doc("the tones themselves, their approximation by two lights (section 4.4), or Phong's model to compare with")
        .options({"tone", "two_lights", "two_lights_per_vertex", "phong", "phong_per_vertex"});
    type.field("parameters", &Gooch::parameters)
        .doc("the surface's own, or the scene's: all other fields are then those of the camera's gooch")
        .options({"own", "scene"});
    type.field("b", &Gooch::b).doc("blue of the cool tone").range(0, 1);
    type.field("y", &Gooch::y).doc("yellow of the warm tone").range(0, 1);
    type.field("alpha", &Gooch::alpha).doc("object colour in the cool tone").range(0, 1);
    type.field("beta", &Gooch::beta).doc("object colour in the warm tone").range(0, 1);
    type.field("highlight", &Gooch::highlight).doc("strength of the highlight; 0 for none").range(0, 1);
    type.field("shininess", &Gooch::shininess).doc("Phong exponent of the highlight").range(1, 10000);
    type.field("printed_equation", &Gooch::printed_equation)
        .doc("weight k_cool with (1 + l.n)/2 as equation 2 is printed, which lights the dark side");
    type.field("clamp_lights", &Gooch::clamp_lights)
        .doc("two_lights: negative colours of lights become 0, as on a pipeline that does not know them");
    type.field("ambient", &Gooch::ambient).doc("phong: ambient light, k_a of equation 1").range(0, 1);
    type.field("diffuse", &Gooch::diffuse).doc("phong: how much of the object colour is k_d of equation 1").range(0, 1);
}

} // namespace hachure
