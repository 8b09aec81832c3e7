// The forms that brushes stamp (systems/implicit_brush/footprint.h): opacity at a place relative to a stamp's middle.
// Defines: TIP, the number of a BrushTip; ROUND where turning changes nothing; HAIRS and DROPS, what bristle and
// splatter are made of.
//
// Rims are smoothed such that a stamp adds its area to the picture at every radius and wherever its middle is: the sum
// over pixels is the integral, within 1 % from radius 1 on for disks (tests/systems/implicit_brush/footprint_gl_test).

uniform float aspect;

#if TIP == 5
layout(binding = 6) uniform sampler2D tip_bitmap; // premultiplied
uniform bool tip_colored;                         // its colours replace the stamp's
#endif

// A place in the stamp's own axes; `turn` is the cosine and sine of its angle.
vec2 in_stamp(vec2 place, vec2 turn) {
    return vec2(dot(place, turn), dot(place, vec2(-turn.y, turn.x)));
}

// Half the sides of a box around a stamp, along and across its angle.
vec2 footprint_box(float radius) {
    vec2 radii = vec2(radius, radius * aspect);
#if TIP == 0
    return max(radii, 1.0) + 1.0;
#elif TIP == 1
    return max(radii, 2.0);
#elif TIP == 2
    return radii * vec2(1.0, LINE_THICKNESS) + 1.0;
#elif TIP == 4
    return radii + 3.0;
#else
    return radii + 1.0;
#endif
}

// How much of -half_ to half_ a tent of one pixel to either side sees from a place.
float tent_integral(float t) {
    t = clamp(t, -1.0, 1.0);
    return 0.5 + t - 0.5 * t * abs(t);
}
float interval(float place, float half_) {
    return tent_integral(place + half_) - tent_integral(place - half_);
}

// A disk. Opacity falls linearly in the squared distance, over half a pixel to either side of the rim: so its integral
// is the area exactly. The mean of four places around the pixel's centre takes out what is left of the pixel grid.
// Smaller ones than radius 1 are drawn at radius 1, fainter.
float round_disk(vec2 place, float radius) {
    float drawn = max(radius, 1.0);
    float steepness = 0.5 / drawn;
    float middle = 0.5 + steepness * (drawn * drawn - dot(place, place) - 0.125);
    vec2 quarter = 0.5 * steepness * place; // how much a quarter pixel along each axis changes
    float plus = quarter.x + quarter.y, minus = quarter.x - quarter.y;
    vec4 opacity = clamp(vec4(middle + plus, middle + minus, middle - minus, middle - plus), 0.0, 1.0);
    float fainter = radius / drawn;
    return 0.25 * fainter * fainter * (opacity.x + opacity.y + opacity.z + opacity.w);
}

// The same of an ellipse, linear in the squared distance along each direction.
float ellipse(vec2 place, vec2 turn, vec2 radii) {
    vec2 drawn = max(radii, 1.0);
    vec2 unit = in_stamp(place, turn) / drawn;
    float distance2 = dot(unit, unit);
    float rim = inversesqrt(dot(unit * unit, 1.0 / (drawn * drawn)) / max(distance2, 1e-6)); // a pixel there
    vec2 first = in_stamp(vec2(0.25, 0.25), turn) / drawn, second = in_stamp(vec2(0.25, -0.25), turn) / drawn;
    vec2 along = 2.0 * vec2(dot(unit, first), dot(unit, second));
    vec2 beyond = distance2 + vec2(dot(first, first), dot(second, second)) - 1.0;
    vec4 opacity = clamp(0.5 - 0.5 * rim * vec4(beyond + along, beyond - along), 0.0, 1.0);
    vec2 fainter = radii / drawn;
    return 0.25 * fainter.x * fainter.y * (opacity.x + opacity.y + opacity.z + opacity.w);
}

// Smooth enough for the pixel grid from radius 2 on.
float soft_disk(vec2 place, vec2 turn, vec2 radii) {
    vec2 drawn = max(radii, 2.0);
#ifdef ROUND
    vec2 unit = place / drawn;
#else
    vec2 unit = in_stamp(place, turn) / drawn;
#endif
    float inside = max(1.0 - dot(unit, unit), 0.0);
    vec2 fainter = radii / drawn;
    return fainter.x * fainter.y * inside * inside;
}

// A bar; `place` is in the stamp's axes.
float bar(vec2 place, vec2 half_) {
    return interval(place.x, half_.x) * interval(place.y, half_.y);
}

#if TIP == 3
const vec4 hairs[HAIR_COUNT] = vec4[](HAIRS);

float bristle(vec2 place, vec2 radii) {
    float opacity = 0.0;
    for (int i = 0; i < HAIR_COUNT; ++i) opacity += bar(place - hairs[i].xy * radii, hairs[i].zw * radii);
    return opacity;
}
#endif

#if TIP == 4
const vec3 drops[DROP_COUNT] = vec3[](DROPS);

// Drops stay round, and are disks with a rim of two pixels: most are small.
float splatter(vec2 place, vec2 radii) {
    float scale = sqrt(radii.x * radii.y), opacity = 0.0;
    for (int i = 0; i < DROP_COUNT; ++i) {
        float radius = drops[i].z * scale, drawn = max(radius, 2.0);
        vec2 beside = place - drops[i].xy * radii;
        float fainter = radius / drawn;
        opacity += fainter * fainter *
                   clamp(0.5 + 0.25 / drawn * (drawn * drawn - dot(beside, beside)), 0.0, 1.0);
    }
    return opacity;
}
#endif

// The opacity of a stamp; `turn` is the cosine and sine of its angle, which a round one does without.
float footprint(vec2 place, vec2 turn, float radius) {
    vec2 radii = vec2(radius, radius * aspect);
#if TIP == 0 && defined(ROUND)
    return round_disk(place, radius);
#elif TIP == 0
    return ellipse(place, turn, radii);
#elif TIP == 1
    return soft_disk(place, turn, radii);
#elif TIP == 2
    return bar(in_stamp(place, turn), radii * vec2(1.0, LINE_THICKNESS));
#elif TIP == 3
    return bristle(in_stamp(place, turn), radii);
#elif TIP == 4
    return splatter(in_stamp(place, turn), radii);
#else
    return 0.0;
#endif
}

#if TIP == 5
// The bitmap's colour and opacity, from the level whose texels are about a pixel.
vec4 bitmap_footprint(vec2 place, vec2 turn, float radius) {
    vec2 radii = vec2(radius, radius * aspect);
    vec2 inside = in_stamp(place, turn);
    vec2 texels = vec2(textureSize(tip_bitmap, 0)) / (2.0 * max(radii, 0.25)); // of a pixel
    float level = max(log2(max(texels.x, texels.y)), 0.0);
    return bar(inside, radii) * textureLod(tip_bitmap, 0.5 + 0.5 * inside / radii, level);
}
#endif
