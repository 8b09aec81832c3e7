#pragma once

#include <hachure/runtime/ecs/reflect.h>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cstdint>
#include <string>

namespace hachure {

/// What lines are found along (Vergne et al. 2011, table 1): the highest places of a height h across a direction
/// theta. Heights are numbers without unit that a change of scale leaves alone: a slope, or how much one changes over
/// `window`.
enum class BrushFeature {
    contours,        ///< depth breaks off: h is the break, along the slope of depth
    surface_edges,   ///< the surface turns steep: h is its slope
    luminance_edges, ///< brightness changes fastest: h is its slope, of tone over `window`
    ridges,          ///< convex curvature is greatest, across its direction
    valleys,         ///< concave curvature is
    inflections,     ///< curvature changes fastest
};

/// What ridges, valleys and inflections are those of.
enum class BrushSource {
    surface,   ///< the surface that is seen; on a picture without depth and normals its luminance
    luminance, ///< the relief that brightness makes: valleys are dark lines
};

/// What lengths are measured in.
enum class BrushUnit {
    pixels,  ///< constant on the screen
    picture, ///< thousandths of the picture's height: the same look at any resolution
    world,   ///< metres: true to distance and field of view
};

/// What a quantity of the brush follows: from its value `weak` at `low` of the profile, to `strong` at `high`.
enum class BrushDriver {
    constant,  ///< nothing: it is `strong` everywhere
    height,    ///< how pronounced the feature is
    curvature, ///< how sharp: the height's fall over half a window beside the line, by its second derivative
};

/// The form that is stamped: all within the unit circle or square, before `size`, `angle` and `aspect`.
enum class BrushTip {
    disk,      ///< evenly opaque
    soft_disk, ///< opaque in the middle, clear at the rim
    line,      ///< a thin bar along the direction of `angle`
    bristle,   ///< a bundle of hairs, as thin bars
    splatter,  ///< drops of different size around the middle
    bitmap,    ///< `tip_file`
};

/// What a stamp's direction is that of.
enum class BrushTurn {
    fixed,  ///< the picture's: `angle` is counter-clockwise from the right
    along,  ///< the line's
    across, ///< the profile's, theta
};

/// Where a stamp's colour comes from.
enum class BrushColor {
    constant, ///< `color`
    profile,  ///< from `weak_color` to `color`, as `color_by` says
    surface,  ///< what is drawn at the feature: the shaded object
};

/// What the noise of a brush holds to.
enum class BrushGrain {
    solid,    ///< the surface: it moves and turns with it, grain of about one size at every distance
    advected, ///< the screen, carried along by motion; for pictures and videos, by what moves in them
    screen,   ///< the screen
};

/// How stamps are added up; all give the same picture.
enum class BrushMethod {
    automatic, ///< whatever is fastest here
    splat,     ///< each stamp is drawn over the pixels that it covers
    gather,    ///< each pixel looks at all pixels in reach
    tiles,     ///< each pixel looks at those in reach that stamp
    sums,      ///< from running sums along rows of where disks begin and end; automatic for what is no round disk
};

/// Lines along features of what is seen, painted by stamping the form of a brush at every pixel near them (Implicit
/// Brushes, Vergne et al. 2011).
///
/// It paints on the surface or picture of its own entity; on an entity that has neither, on those of its parent and all
/// below that; on a camera, or on an entity at the root of the scene, on everything in the view. So a character, or a
/// view, can have any number of brushes: one entity each. Brushes that are alike in everything are painted as one.
/// Brushes of the same feature, settings of `diffusion`, `window` and `source` share its extraction.
struct ImplicitBrush {
    BrushFeature feature = BrushFeature::contours;
    std::int32_t order = 0;
    bool visible = true;

    // Where lines are (section 3).
    BrushSource source = BrushSource::surface;
    std::int32_t diffusion = 4;
    float window = 6.0f;
    BrushUnit unit = BrushUnit::pixels;

    // How much each pixel near them counts (section 4.1, weight function).
    float peak = 1.0f;
    BrushDriver peak_by = BrushDriver::height;
    float peak_low = 0.2f;
    float peak_high = 0.5f;
    float spread = 0.6f;
    float weak_spread = 2.0f;
    BrushDriver spread_by = BrushDriver::constant;
    float spread_low = 0.0f;
    float spread_high = 1.0f;

    // What is stamped there (brush function).
    BrushTip tip = BrushTip::disk;
    std::string tip_file;
    float size = 1.5f;
    float weak_size = 0.5f;
    BrushDriver size_by = BrushDriver::constant;
    float size_low = 0.0f;
    float size_high = 1.0f;
    float aspect = 1.0f;
    BrushTurn turn = BrushTurn::fixed;
    float angle = 0.0f;
    float shift_along = 0.0f;
    float shift_across = 0.0f;
    BrushColor coloring = BrushColor::constant;
    BrushDriver color_by = BrushDriver::height;
    float color_low = 0.0f;
    float color_high = 1.0f;
    glm::vec3 color{0.0f};
    glm::vec3 weak_color{0.5f};
    float opacity = 1.0f;
    float contrast = 40.0f;

    // What is not of the feature (noise).
    float canvas = 0.0f;
    float interruption = 0.0f;
    float wobble = 0.0f;
    float turn_noise = 0.0f;
    float size_noise = 0.0f;
    float color_noise = 0.0f;
    float grain_size = 12.0f;
    BrushGrain grain = BrushGrain::solid;
    float flatness = 1.0f;
    std::int32_t seed = 1;

    // How it is computed.
    float cutoff = 0.004f;
    BrushMethod method = BrushMethod::automatic;

    friend bool operator==(const ImplicitBrush&, const ImplicitBrush&) = default;
};

inline void reflect(TypeBuilder<ImplicitBrush>& type) {
    type.name("implicit_brush").doc("lines along features of what is seen, painted with a brush (Vergne 2011)");
    type.field("feature", &ImplicitBrush::feature)
        .doc("what lines are along: occluding contours, surface edges, luminance edges, ridges, valleys, inflections")
        .options({"contours", "surface_edges", "luminance_edges", "ridges", "valleys", "inflections"});
    type.field("order", &ImplicitBrush::order)
        .doc("brushes of higher order lie over those of lower; of the same, those made later")
        .range(-1000, 1000);
    type.field("visible", &ImplicitBrush::visible).doc("is drawn");
    type.field("source", &ImplicitBrush::source)
        .doc("what ridges, valleys and inflections are those of: the surface, or the relief of its luminance")
        .options({"surface", "luminance"});
    type.field("diffusion", &ImplicitBrush::diffusion)
        .doc("steps of smoothing, which stop at contours: more leave coarser features; each adds about a pixel's "
             "variance")
        .range(0, 200);
    type.field("window", &ImplicitBrush::window)
        .doc("how far a pixel looks for a line on either side, in `unit`")
        .range(0.001, 1000);
    type.field("unit", &ImplicitBrush::unit)
        .doc("unit of lengths: pixels, thousandths of the picture's height, or metres")
        .options({"pixels", "picture", "world"});
    type.field("peak", &ImplicitBrush::peak).doc("weight of a pixel on a line").range(0, 1);
    type.field("peak_by", &ImplicitBrush::peak_by)
        .doc("what the weight follows, from 0 at peak_low to `peak` at peak_high")
        .options({"constant", "height", "curvature"});
    type.field("peak_low", &ImplicitBrush::peak_low).doc("below this a feature has no line").range(0, 1000);
    type.field("peak_high", &ImplicitBrush::peak_high).doc("from this on its line has full weight").range(0, 1000);
    type.field("spread", &ImplicitBrush::spread)
        .doc("how far from the line pixels still count: standard deviation, in `unit`")
        .range(0, 1000);
    type.field("weak_spread", &ImplicitBrush::weak_spread)
        .doc("the same at and below spread_low, with spread_by")
        .range(0, 1000);
    type.field("spread_by", &ImplicitBrush::spread_by)
        .doc("what the spread follows, from weak_spread at spread_low to `spread` at spread_high")
        .options({"constant", "height", "curvature"});
    type.field("spread_low", &ImplicitBrush::spread_low).doc("see spread_by").range(0, 1000);
    type.field("spread_high", &ImplicitBrush::spread_high).doc("see spread_by").range(0, 1000);
    type.field("tip", &ImplicitBrush::tip)
        .doc("the form that is stamped")
        .options({"disk", "soft_disk", "line", "bristle", "splatter", "bitmap"});
    type.field("tip_file", &ImplicitBrush::tip_file)
        .doc("the form of tip bitmap: dark, or opaque where it has an alpha channel, for where there is ink; its "
             "colours count where it has them")
        .unit("image file");
    type.field("size", &ImplicitBrush::size).doc("radius of a stamp, in `unit`").range(0, 1000);
    type.field("weak_size", &ImplicitBrush::weak_size)
        .doc("the same at and below size_low, with size_by")
        .range(0, 1000);
    type.field("size_by", &ImplicitBrush::size_by)
        .doc("what the size follows, from weak_size at size_low to `size` at size_high")
        .options({"constant", "height", "curvature"});
    type.field("size_low", &ImplicitBrush::size_low).doc("see size_by").range(0, 1000);
    type.field("size_high", &ImplicitBrush::size_high).doc("see size_by").range(0, 1000);
    type.field("aspect", &ImplicitBrush::aspect).doc("height of a stamp as a part of its width").range(0.01, 1);
    type.field("turn", &ImplicitBrush::turn)
        .doc("what stamps are turned with: nothing, along the line, or across it")
        .options({"fixed", "along", "across"});
    type.field("angle", &ImplicitBrush::angle).doc("turns stamps further").unit("rad").range(-6.2832, 6.2832);
    type.field("shift_along", &ImplicitBrush::shift_along)
        .doc("moves stamps along their line, in radii of the stamp")
        .range(-4, 4);
    type.field("shift_across", &ImplicitBrush::shift_across)
        .doc("moves stamps across their line, towards where theta points, in radii")
        .range(-4, 4);
    type.field("coloring", &ImplicitBrush::coloring)
        .doc("where colour comes from: `color`, the profile, or the shaded object at the line")
        .options({"constant", "profile", "surface"});
    type.field("color_by", &ImplicitBrush::color_by)
        .doc("what colour follows, from weak_color at color_low to `color` at color_high")
        .options({"constant", "height", "curvature"});
    type.field("color_low", &ImplicitBrush::color_low).doc("see color_by").range(0, 1000);
    type.field("color_high", &ImplicitBrush::color_high).doc("see color_by").range(0, 1000);
    type.field("color", &ImplicitBrush::color).color().doc("colour of the ink");
    type.field("weak_color", &ImplicitBrush::weak_color).color().doc("colour of weak features, with coloring profile");
    type.field("opacity", &ImplicitBrush::opacity).doc("opacity of the lines").range(0, 1);
    type.field("contrast", &ImplicitBrush::contrast)
        .doc("how soon stamps that lie over each other are opaque: p of Schlick's tone mapping; 1 for not sooner than "
             "when all pixels under the brush count")
        .range(1, 1000);
    type.field("canvas", &ImplicitBrush::canvas).doc("how much noise takes from the ink, as rough canvas").range(0, 1);
    type.field("interruption", &ImplicitBrush::interruption).doc("how much of the lines noise leaves out").range(0, 1);
    type.field("wobble", &ImplicitBrush::wobble).doc("how far noise moves stamps, in radii of the stamp").range(0, 8);
    type.field("turn_noise", &ImplicitBrush::turn_noise).doc("how far noise turns stamps").unit("rad").range(0, 3.1416);
    type.field("size_noise", &ImplicitBrush::size_noise)
        .doc("how much smaller noise makes stamps, as a part of their size")
        .range(0, 1);
    type.field("color_noise", &ImplicitBrush::color_noise).doc("how much noise changes colours").range(0, 1);
    type.field("grain_size", &ImplicitBrush::grain_size)
        .doc("size of the noise's grains, in `unit`")
        .range(0.001, 1000);
    type.field("grain", &ImplicitBrush::grain)
        .doc("what noise holds to: the surface, the screen carried along by motion, or the screen")
        .options({"solid", "advected", "screen"});
    type.field("flatness", &ImplicitBrush::flatness)
        .doc("1 for noise that lies in the picture's plane, grains of one size; 0 for noise that keeps to what it is "
             "painted on in every motion, with grains that grow and tilt with it")
        .range(0, 1);
    type.field("seed", &ImplicitBrush::seed).doc("which noise").range(0, 1000000);
    type.field("cutoff", &ImplicitBrush::cutoff)
        .doc("weight below which a pixel is left out: more is faster and paler")
        .range(0, 0.5);
    type.field("method", &ImplicitBrush::method)
        .doc("how stamps are added up: whatever is fastest here, or one way")
        .options({"automatic", "splat", "gather", "tiles", "sums"});
}

} // namespace hachure
