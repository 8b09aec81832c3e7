#pragma once

#include <hachure/runtime/ecs/reflect.h>

#include <glm/vec3.hpp>

namespace hachure {

/// Cool-to-warm tone shading of technical illustration (Gooch et al. 1998, section 4.2). Colours are linear RGB:
///
///     k_cool = (0, 0, b) + alpha k_d        k_warm = (y, y, 0) + beta k_d        (equation 3)
///     I = (1 - w) k_cool + w k_warm,        w = (1 + l.n) / 2                    (equation 2, see printed_equation)
///
/// and a Phong highlight of the light's colour, white by default, is laid over it. The defaults are figure 7's.
struct Gooch {
    float b = 0.4f;
    float y = 0.4f;
    float alpha = 0.2f;
    float beta = 0.6f;
    float highlight = 0.8f;
    float shininess = 40.0f;
    bool printed_equation = false;

    friend bool operator==(const Gooch&, const Gooch&) = default;
};

inline void reflect(TypeBuilder<Gooch>& type) {
    type.name("gooch").doc("cool-to-warm tone shading (Gooch 1998)");
    type.field("b", &Gooch::b).doc("blue of the cool tone").range(0, 1);
    type.field("y", &Gooch::y).doc("yellow of the warm tone").range(0, 1);
    type.field("alpha", &Gooch::alpha).doc("object colour in the cool tone").range(0, 1);
    type.field("beta", &Gooch::beta).doc("object colour in the warm tone").range(0, 1);
    type.field("highlight", &Gooch::highlight).doc("strength of the highlight; 0 for none").range(0, 1);
    type.field("shininess", &Gooch::shininess).doc("Phong exponent of the highlight").range(1, 10000);
    type.field("printed_equation", &Gooch::printed_equation)
        .doc("weight k_cool with (1 + l.n)/2 as equation 2 is printed, which lights the dark side");
}

} // namespace hachure
