#pragma once

#include <hachure/runtime/ecs/reflect.h>

#include <glm/vec3.hpp>

#include <cstdint>
#include <string>

namespace hachure {

/// What shade strokes are drawn with.
enum class ShadeTip { pencil, ink, charcoal };

/// What makes shade fainter in places.
enum class ShadeDensityBy {
    nothing,
    paint,   ///< a channel of the vertex colours
    texture, ///< the brightness of a picture, by texture coordinates
    volumes, ///< entities with a shade volume
};

/// The channel of the vertex colours that paints density.
enum class ShadePaintChannel { red, green, blue, alpha };

/// Sketchy strokes where a surface is dark, which follow the light (Sorman & Hult 2005). Lengths are over the size of
/// the model, the diagonal of its bounds, so that they suit it whatever its units.
struct ShadeStrokes {
    float amplitude = 0.028f;
    float amplitude_by_curvature = 0.3f;
    float min_amplitude = 0.012f;
    float max_amplitude = 0.04f;
    float intensity = 1.0f;
    float density = 0.6f;
    float chain_turn = 1.6f;
    float trueness = 0.9f;
    float line_width = 1.2f;
    float full_shade = 0.0f;
    float no_shade = 0.85f;
    float contrast = 1.0f;
    float full_light = 0.0f;
    float dead_band = 0.0025f;
    std::uint32_t cells = 4000;
    std::uint32_t seed = 1;
    ShadeTip tip = ShadeTip::pencil;
    glm::vec3 color{0.05f};
    float opacity = 0.85f;
    float flicker = 0.0f;
    float flicker_rate = 12.0f;
    ShadeDensityBy density_by = ShadeDensityBy::nothing;
    ShadePaintChannel density_channel = ShadePaintChannel::alpha;
    std::string density_texture;

    friend bool operator==(const ShadeStrokes&, const ShadeStrokes&) = default;
};

inline void reflect(TypeBuilder<ShadeStrokes>& type) {
    type.name("shade_strokes").doc("sketchy strokes where a surface is dark, which follow the light (Sorman 2005)");
    type.field("amplitude", &ShadeStrokes::amplitude)
        .doc("half the width of a chain's zigzag, over the model's size")
        .range(0.0001, 0.5);
    type.field("amplitude_by_curvature", &ShadeStrokes::amplitude_by_curvature)
        .doc("how much that follows the radius of the surface's curvature: small features get delicate strokes")
        .range(0, 1);
    type.field("min_amplitude", &ShadeStrokes::min_amplitude)
        .doc("least amplitude by curvature, over the model's size")
        .range(0.0001, 0.5);
    type.field("max_amplitude", &ShadeStrokes::max_amplitude)
        .doc("greatest amplitude by curvature, over the model's size: that of planes")
        .range(0.0001, 0.5);
    type.field("intensity", &ShadeStrokes::intensity)
        .doc("how many zigzags there are per length on the screen; the shade stays, lines get finer")
        .range(0.1, 10);
    type.field("density", &ShadeStrokes::density)
        .doc("shade that strokes stand for where they cover the surface: the greater, the fewer are drawn")
        .range(0.05, 4);
    type.field("chain_turn", &ShadeStrokes::chain_turn)
        .doc("how far the surface may turn along a chain of strokes, end to end: the chain's length")
        .unit("rad")
        .range(0.05, 3.1416);
    type.field("trueness", &ShadeStrokes::trueness)
        .doc("how closely strokes follow the surface's second principal direction; 0 for any direction")
        .range(0, 1);
    type.field("line_width", &ShadeStrokes::line_width).doc("width of the strokes").unit("px").range(0.25, 64);
    type.field("full_shade", &ShadeStrokes::full_shade).doc("light up to which shade is full").range(0, 1);
    type.field("no_shade", &ShadeStrokes::no_shade).doc("light from which there is no shade").range(0, 1);
    type.field("contrast", &ShadeStrokes::contrast)
        .doc("exponent of shade between the two: above 1 keeps strokes to the dark")
        .range(0.1, 10);
    type.field("full_light", &ShadeStrokes::full_light)
        .doc("intensity of a light that counts as 1, for lights that dim; 0: that of the scene's strongest light")
        .range(0, 1e9);
    type.field("dead_band", &ShadeStrokes::dead_band)
        .doc("shade by which a place may be off before its strokes change: greater is cheaper and calmer")
        .range(0.001, 0.5);
    type.field("cells", &ShadeStrokes::cells)
        .doc("into about how many cells the surface is divided to look at its light: more follow finer shadows")
        .range(50, 1000000);
    type.field("seed", &ShadeStrokes::seed).doc("another number draws other strokes");
    type.field("tip", &ShadeStrokes::tip).doc("what strokes are drawn with").options({"pencil", "ink", "charcoal"});
    type.field("color", &ShadeStrokes::color).color().doc("colour of the strokes");
    type.field("opacity", &ShadeStrokes::opacity).doc("how dark the strongest stroke is").range(0, 1);
    type.field("flicker", &ShadeStrokes::flicker)
        .doc("how far strokes jump about, over their amplitude, as in stop motion; 0 for still ones")
        .range(0, 1);
    type.field("flicker_rate", &ShadeStrokes::flicker_rate).doc("how often they do").unit("1/s").range(0.1, 120);
    type.field("density_by", &ShadeStrokes::density_by)
        .doc("what makes shade fainter in places: 0 there for none, 1 for all of it")
        .options({"nothing", "paint", "texture", "volumes"});
    type.field("density_channel", &ShadeStrokes::density_channel)
        .doc("the channel of the vertex colours (paint)")
        .options({"red", "green", "blue", "alpha"});
    type.field("density_texture", &ShadeStrokes::density_texture)
        .doc("the picture whose brightness it is (texture)")
        .unit("image file");
}

} // namespace hachure
