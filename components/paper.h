#pragma once

#include <hachure/runtime/ecs/reflect.h>

#include <cstdint>
#include <string>

namespace hachure {

/// The relief of paper that needs no file.
enum class PaperKind {
    tooth,      ///< fine and even: drawing paper
    cold_press, ///< rounded bumps between pits: watercolour paper
    laid,       ///< close ribs crossed by wide chain lines: Ingres paper
    canvas,     ///< a plain weave
};

/// What the sizes of paper are measured in.
enum class PaperUnit {
    pixels,  ///< constant on the screen
    picture, ///< thousandths of the picture's height: the same look at any resolution
};

/// A medium on paper: peaks of its relief catch pigment, valleys resist it (Kalnins et al. 2002). On the camera's
/// entity; what is bare has the colour of Compose::background.
struct Paper {
    float strength = 1.0f;
    bool on_lines = true;
    bool on_shading = true;
    PaperKind kind = PaperKind::tooth;
    std::string file;
    float scale = 1.0f;
    PaperUnit scale_unit = PaperUnit::pixels;
    std::int32_t seed = 1;
    float pressure = 1.0f;
    float softness = 0.7f;

    friend bool operator==(const Paper&, const Paper&) = default;
};

inline void reflect(TypeBuilder<Paper>& type) {
    type.name("paper").doc("a medium on paper: peaks of its relief catch pigment, valleys resist it (Kalnins 2002)");
    type.field("strength", &Paper::strength).doc("how much the relief counts; 0 for none of it").range(0, 1);
    type.field("on_lines", &Paper::on_lines).doc("lines show the paper");
    type.field("on_shading", &Paper::on_shading).doc("shaded surfaces show the paper");
    type.field("kind", &Paper::kind)
        .doc("the paper: fine tooth, bumps of cold press, ribs of laid paper, weave of canvas")
        .options({"tooth", "cold_press", "laid", "canvas"});
    type.field("file", &Paper::file)
        .doc("heights instead of `kind`: a picture that tiles, peaks light; empty for none")
        .unit("image file");
    type.field("scale", &Paper::scale)
        .doc("size of the relief, in scale_unit: of a texel of the file; 1 is a grain of some 5")
        .range(0.5, 8);
    type.field("scale_unit", &Paper::scale_unit)
        .doc("pixels, or thousandths of the picture's height for the same look at any resolution")
        .options({"pixels", "picture"});
    type.field("seed", &Paper::seed).doc("which sheet of the kind").range(0, 1000000);
    type.field("pressure", &Paper::pressure)
        .doc("how hard the medium is pressed: 1 keeps tones, less leaves paper bare in the darkest of them")
        .range(0, 1);
    type.field("softness", &Paper::softness)
        .doc("between valleys and peaks: 0 for pigment that sticks or does not, 1 for a smooth passage")
        .range(0, 1);
}

} // namespace hachure
