// A brush; systems/implicit_brush/brush_style.h is the same. Lengths are in pixels, or in metres where scale.y is 1.
struct BrushStyle {
    vec4 peak;       // at the lower limit, at the upper limit; the limits
    vec4 spread;     // likewise
    vec4 size;       // likewise
    vec4 color;      // w: how much noise changes it
    vec4 weak_color; // w: angle, radians
    vec4 tint;       // 0 and 1; limits of what colour follows
    vec4 drivers;    // what peak, spread, size, colour follow
    vec4 choices;    // what turns stamps, where colour is from; shift along and across, radii
    vec4 noise;      // interruption, wobble (radii), turn (radians), size
    vec4 scale;      // cutoff; 1 where lengths are in metres; largest radius, px
};
layout(std140, binding = 2) uniform Style { BrushStyle style; };

const float follows_height = 1.0; // of drivers; 0: nothing
const float turned_along = 1.0, turned_across = 2.0;
const float colored_by_profile = 1.0, colored_by_surface = 2.0;

// A quantity between its values at two limits, by what it follows of a profile.
float driven(vec4 range, float driver, float height, float curvature) {
    if (driver == 0.0) return range.y;
    float value = driver == follows_height ? height : curvature;
    return mix(range.x, range.y, clamp((value - range.z) / (range.w - range.z), 0.0, 1.0));
}
