#pragma once

#include <hachure/runtime/ecs/reflect.h>

#include <glm/vec3.hpp>

#include <string>

namespace hachure {

/// What a line's width is measured in.
enum class ToneLineUnit {
    pixels,  ///< constant on the screen
    picture, ///< thousandths of the picture's height: the same look at any resolution
};

/// What makes lines thinner in places, and with them the detail that they find (section 3.4).
enum class LineAbstraction {
    constant,    ///< nothing does
    depth,       ///< distance from the eye
    edge_length, ///< the mesh's own edges: thin lines where it is fine (figure 7)
    paint,       ///< a channel of the vertex colours
};

/// A channel of the vertex colours.
enum class PaintChannel { red, green, blue, alpha };

/// How lines are drawn.
enum class ToneLineMethod {
    pixels,  ///< by every pixel for itself, as the paper does
    strokes, ///< as strokes along the ridges of the tone image
};

/// Lines where the shaded picture is thin, dark or bright, and where its tone breaks off (Lee et al. 2007).
///
/// Curvature c is in tone (0 black, 1 white) over half a line's width: how far the tone changes from the middle of a
/// line to a place half a width beside it, by the fitted parabola. It means the same at every width.
struct AbstractedLines {
    bool dark = true;
    bool highlight = true;
    bool specular = true;
    bool specular_dark = false;
    float width = 5.0f;
    ToneLineUnit width_unit = ToneLineUnit::pixels;
    LineAbstraction width_by = LineAbstraction::constant;
    float min_width = 2.0f;
    float full_width_distance = 0.0f;
    PaintChannel paint_channel = PaintChannel::alpha;
    float beta = 0.1f;
    float dark_low = 0.006f;
    float dark_high = 0.02f;
    float highlight_low = 0.02f;
    float highlight_high = 0.05f;
    float fade = 0.5f;
    float counterchange = 0.25f;
    glm::vec3 color{0.0f};
    glm::vec3 highlight_color{1.0f};
    float wrap = 0.0f;
    float albedo = 0.0f;
    float shininess = 40.0f;
    bool abstracted_normals = false;
    ToneLineMethod method = ToneLineMethod::pixels;
    float taper = 3.0f;
    std::string stroke_texture;
    float texture_length = 24.0f;
    float texture_strength = 0.6f;
    float min_length = 0.0f;

    friend bool operator==(const AbstractedLines&, const AbstractedLines&) = default;
};

inline void reflect(TypeBuilder<AbstractedLines>& type) {
    type.name("abstracted_lines")
        .doc("lines where the shaded picture is thin, dark or bright, and where its tone breaks off (Lee 2007)");
    type.field("dark", &AbstractedLines::dark).doc("draw lines along thin dark areas of the diffuse tone");
    type.field("highlight", &AbstractedLines::highlight).doc("draw lines along thin bright areas of the diffuse tone");
    type.field("specular", &AbstractedLines::specular).doc("draw lines along thin specular highlights");
    type.field("specular_dark", &AbstractedLines::specular_dark)
        .doc("draw lines along thin gaps between specular highlights");
    type.field("width", &AbstractedLines::width).doc("width of the lines, in width_unit").range(0, 64);
    type.field("width_unit", &AbstractedLines::width_unit)
        .doc("pixels, or thousandths of the picture's height for the same look at any resolution")
        .options({"pixels", "picture"});
    type.field("width_by", &AbstractedLines::width_by)
        .doc("what makes lines thinner in places: distance, short edges of the mesh, or vertex colours")
        .options({"constant", "depth", "edge_length", "paint"});
    type.field("min_width", &AbstractedLines::min_width).doc("least width, in width_unit").range(0, 64);
    type.field("full_width_distance", &AbstractedLines::full_width_distance)
        .doc("distance up to which lines are `width` wide (depth); 0 for where the surface begins")
        .unit("m")
        .range(0, 1e9);
    type.field("paint_channel", &AbstractedLines::paint_channel)
        .doc("the channel of the vertex colours that scales the width (paint)")
        .options({"red", "green", "blue", "alpha"});
    type.field("beta", &AbstractedLines::beta)
        .doc("how far a step of the search goes towards the line: 0 also draws edges of tones, 1 thin areas alone")
        .range(0, 1);
    type.field("dark_low", &AbstractedLines::dark_low)
        .doc("curvature from which dark lines begin to show: change of tone over half a width")
        .range(0.0001, 1);
    type.field("dark_high", &AbstractedLines::dark_high).doc("curvature from which they are opaque").range(0.0001, 1);
    type.field("highlight_low", &AbstractedLines::highlight_low)
        .doc("curvature from which highlight lines begin to show")
        .range(0.0001, 1);
    type.field("highlight_high", &AbstractedLines::highlight_high)
        .doc("curvature from which they are opaque")
        .range(0.0001, 1);
    type.field("fade", &AbstractedLines::fade)
        .doc("part of half the width over which a line fades towards its rim; 0 for a rim as sharp as pixels allow")
        .range(0, 1);
    type.field("counterchange", &AbstractedLines::counterchange)
        .doc("how much lighter dark lines are where the tone is light, and highlight lines where it is dark")
        .range(0, 1);
    type.field("color", &AbstractedLines::color).color().doc("colour of dark lines");
    type.field("highlight_color", &AbstractedLines::highlight_color).color().doc("colour of highlight lines");
    type.field("wrap", &AbstractedLines::wrap)
        .doc("how far light reaches round the surface in the tone image: 0 for half of it, 1 for all")
        .range(0, 1);
    type.field("albedo", &AbstractedLines::albedo)
        .doc("how much the material's own brightness counts in the tone image")
        .range(0, 1);
    type.field("shininess", &AbstractedLines::shininess)
        .doc("exponent of specular highlights in the tone image")
        .range(1, 10000);
    type.field("abstracted_normals", &AbstractedLines::abstracted_normals)
        .doc("shade the tone image with the normals that toon.abstraction makes");
    type.field("method", &AbstractedLines::method)
        .doc("how lines are drawn: by pixels, or as strokes along them")
        .options({"pixels", "strokes"});
    type.field("taper", &AbstractedLines::taper)
        .doc("length over which a stroke thins out towards its ends, in widths of it")
        .range(0, 100);
    type.field("stroke_texture", &AbstractedLines::stroke_texture)
        .doc("picture of a stroke from left to right, laid along strokes and mirrored where it ends: dark, or opaque "
             "where it has an alpha channel, for where there is ink; none for dry ink")
        .unit("image file");
    type.field("texture_length", &AbstractedLines::texture_length)
        .doc("about how long the picture is on a stroke, in widths of the lines")
        .range(1, 1000);
    type.field("texture_strength", &AbstractedLines::texture_strength)
        .doc("how much of the texture shows; 0 for solid strokes")
        .range(0, 1);
    type.field("min_length", &AbstractedLines::min_length)
        .doc("strokes shorter than this, in widths of the lines, are left out, unless they link others")
        .range(0, 1000);
}

} // namespace hachure
