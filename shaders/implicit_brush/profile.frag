#version 450 core
// From a pixel along theta to its line: profile sampling (section 3.2.2) and fitting (3.2.3).
// Define: TAPS; FITS; JUNCTIONS for pixels near singularities, which look in more directions than theta's.
#include "implicit_brush/profile_texel.glsl"
#include "implicit_brush/window.glsl"
#include "implicit_brush/cubic.glsl"

uniform float most_singular; // Gamma_max, px: how much singularity, over a way, ends it

layout(location = 0) out vec4 out_profile;

struct Profile {
    bool found;
    vec2 offset; // px
    float height, curvature;
};
const Profile nothing = Profile(false, vec2(1e4), 0.0, 0.0);

Cubic fit_at(vec2 middle, vec2 way) {
    vec4 sums = vec4(0.0);
    float squares = 0.0, reference = height_at(middle); // so that squares of what differs little keep their digits
    for (int i = -TAPS; i <= TAPS; ++i) {
        float u = float(i) / K, h = height_at(middle + u * way) - reference;
        sums += h * vec4(1.0, u, u * u, u * u * u);
        squares += h * h;
    }
    Cubic p = fit_cubic(sums, squares);
    p.d += reference;
    return p;
}

// Singularities of theta alone stay below this, contours are above.
const float contour_singularity = 0.8;

// How far a pixel can look along a direction on both sides until it has met too much of singularities, px. What they
// exceed `least` by counts.
float clear_way(vec2 theta, float width, float least) {
    float steps = ceil(width / 1.5), spacing = width / steps;
    float before = 0.5 * spacing * max(singularity_at(vec2(0.0)) - least, 0.0), after = before;
    if (before > most_singular) return 0.0;
    for (float i = 1.0; i <= steps; i += 1.0) {
        float more_before = spacing * max(singularity_at(-i * spacing * theta) - least, 0.0);
        float more_after = spacing * max(singularity_at(i * spacing * theta) - least, 0.0);
        float most = max(before + more_before, after + more_after);
        if (most > most_singular) {
            float gained = before + more_before > after + more_after ? more_before : more_after;
            return spacing * (i - min((most - most_singular) / gained, 1.0));
        }
        before += more_before, after += more_after;
    }
    return width;
}

const float least_way = 1.5;      // px: less shows no maximum
const float well_explained = 0.7; // of the variance: what a cubic makes of more than one line is worse
const int HALVINGS = 2;
const float junction_window = 4.0; // px: farther away lines are found by who is beside one alone

// `width`: the window; `way`: what of it can be looked along `theta`.
Profile follow(vec2 theta, float width, float way) {
    if (!(way >= least_way)) return nothing;
    vec2 middle = vec2(0.0), found = vec2(2.0, 0.0);
    Cubic fit;
    // The first fit is that of the paper, of as much of the window as a cubic can be laid through. Seen from the side a
    // profile is no cubic: those that follow are of its middle half alone, about where the one before says that it is,
    // and all pixels of a profile end with the same.
    float span = way;
    int done = 0;
    for (int i = 0; i < FITS + HALVINGS; ++i) {
        fit = fit_at(middle, span * theta);
        if (done == 0 && fit.explained < well_explained && i < HALVINGS && span >= 2.0 * least_way) {
            span *= 0.5;
            continue;
        }
        found = maximum(fit);
        if (++done == FITS || !(abs(found.x) <= 1.0)) break;
        middle += found.x * span * theta;
        span = min(span, max(0.5 * width, least_way));
    }
    if (!(abs(found.x) <= 1.0) || fit.explained < well_explained) return nothing;
    float curvature = 0.25 * found.y * width * width / (span * span);
    return Profile(true, middle + found.x * span * theta, value(fit, found.x), curvature);
}

bool is_line(Profile p, float width) {
    return p.found && p.height > 0.0 && p.height < 6e4 && dot(p.offset, p.offset) <= 1.44 * width * width;
}

#ifdef JUNCTIONS
// Where lines meet, theta is that of neither, and singular: a way along it ends at once. Lines are there all the same, as
// h shows to who looks across them. Of all directions the one counts that a line is nearest in. Only contours end a way
// then.
// Beside a contour a direction is as good as cut off: what looks like a line along it is the contour's.
Profile look_around(float width) {
    Profile nearest = nothing;
    float least = width;
    for (int i = 0; i < 4; ++i) {
        float angle = 0.7853981634 * float(i);
        vec2 direction = vec2(cos(angle), sin(angle));
        float way = clear_way(direction, width, contour_singularity);
        Profile p = follow(direction, width, way);
        least = min(least, way);
        if (is_line(p, width) && dot(p.offset, p.offset) < dot(nearest.offset, nearest.offset)) nearest = p;
    }
    if (least < width) return nothing;
    return nearest;
}
#endif

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    float width = window_at(pixel);
    vec4 here = texelFetch(features, pixel, 0);
    vec2 theta = direction_of(here.gb);
    Profile p = nothing;
    if (theta != vec2(0.0)) p = follow(theta, width, clear_way(theta, width, 0.0));
#ifdef JUNCTIONS
    if (!is_line(p, width)) p = look_around(min(width, junction_window));
#endif
    out_profile =
        is_line(p, width) ? vec4(p.offset, p.height, min(p.curvature, 6e4)) : vec4(1e4, 1e4, 0.0, 0.0);
}
