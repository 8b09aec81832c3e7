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

// A trajectory about a place: the paper's straight line is its first order, and finds a line along every ring whose h
// falls outwards, since it leaves the ring; so this is the second.
struct Trajectory {
    vec2 middle;    // px from the pixel's centre
    vec2 direction; // theta there, unit
    float bend;     // curvature, 1/px, to the left of `direction`
};

vec2 place_on(Trajectory way, float t) {
    vec2 left = vec2(-way.direction.y, way.direction.x);
    return way.middle + t * way.direction + (0.5 * way.bend * t * t) * left;
}

Trajectory moved(Trajectory way, float t) {
    vec2 left = vec2(-way.direction.y, way.direction.x);
    return Trajectory(place_on(way, t), normalize(way.direction + way.bend * t * left), way.bend);
}

// Through the pixel along theta, as theta turns beside it.
Trajectory trajectory_at(vec2 theta, float width) {
    const float beside = 1.5; // px
    vec2 before = twice_angle_at(-beside * theta), after = twice_angle_at(beside * theta);
    float turn = 0.5 * (before.x * after.y - before.y * after.x); // of theta, half that of twice its angle
    float bend = clamp(turn / (2.0 * beside), -0.5 / width, 0.5 / width);
    return Trajectory(vec2(0.0), theta, bend);
}

Cubic fit_at(Trajectory way, float span) {
    vec4 sums = vec4(0.0);
    // About the middle's height, so that squares of what differs little keep their digits.
    float squares = 0.0, reference = height_at(way.middle);
    for (int i = -TAPS; i <= TAPS; ++i) {
        float u = float(i) / K, h = height_at(place_on(way, u * span)) - reference;
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
// What falls by less than this part of its height over half a window is level, and has no line: it fades.
const float level = 0.006;
const int HALVINGS = 2;
const float junction_window = 4.0; // px: farther away lines are found by who is beside one alone

// `width`: the window; `clear`: what of it can be looked along.
Profile follow(Trajectory way, float width, float clear) {
    if (!(clear >= least_way)) return nothing;
    vec2 found = vec2(2.0, 0.0);
    Cubic fit;
    // The first fit is that of the paper, of as much of the window as a cubic can be laid through. Seen from the side a
    // profile is no cubic: those that follow are of its middle half alone, about where the one before says that it is,
    // and all pixels of a profile end with the same.
    float span = clear;
    int done = 0;
    for (int i = 0; i < FITS + HALVINGS; ++i) {
        fit = fit_at(way, span);
        if (done == 0 && fit.explained < well_explained && i < HALVINGS && span >= 2.0 * least_way) {
            span *= 0.5;
            continue;
        }
        found = maximum(fit);
        if (++done == FITS || !(abs(found.x) <= 1.0)) break;
        way = moved(way, found.x * span);
        span = min(span, max(0.5 * width, least_way));
    }
    if (!(abs(found.x) <= 1.0) || fit.explained < well_explained) return nothing;
    float height = value(fit, found.x), curvature = 0.25 * found.y * width * width / (span * span);
    height *= smoothstep(level, 4.0 * level, curvature / max(abs(height), 1e-6));
    return Profile(true, place_on(way, found.x * span), height, curvature);
}

bool is_line(Profile p, float width) {
    return p.found && p.height > 0.0 && p.height < 6e4 && dot(p.offset, p.offset) <= 1.44 * width * width;
}

// What a straight way shows of a ring is a chord, whose height is level: a line is sharper than that.
bool is_sharp(Profile p) { return p.curvature > 8.0 * level * p.height; }

// Nearby lines are looked for straight ahead, in less than the window; curvatures are those of the whole one.
Profile follow_straight(vec2 direction, float width, float clear) {
    float near = min(width, junction_window);
    Profile p = follow(Trajectory(vec2(0.0), direction, 0.0), near, min(clear, near));
    if (!is_line(p, near) || !is_sharp(p)) return nothing;
    p.curvature *= width * width / (near * near);
    return p;
}

// Beside a line that another one joins theta turns towards that one, and a way that turns with it may find neither.
Profile look_along(vec2 theta, float width) {
    float clear = clear_way(theta, width, 0.0);
    Profile p = follow(trajectory_at(theta, width), width, clear);
    return is_line(p, width) ? p : follow_straight(theta, width, clear);
}

#ifdef JUNCTIONS
// Where lines meet, theta is that of neither, and singular: a way along it ends at once. Lines are there all the same, as
// h shows to who looks across them. Of all directions the one counts that a line is nearest in. Only contours end a way
// then.
// Beside a contour a direction is as good as cut off: what looks like a line along it is the contour's.
Profile look_around(float width) {
    Profile nearest = nothing;
    float near = min(width, junction_window), least = near;
    for (int i = 0; i < 6; ++i) {
        float angle = 0.5235987756 * float(i);
        vec2 direction = vec2(cos(angle), sin(angle));
        float clear = clear_way(direction, near, contour_singularity);
        least = min(least, clear);
        Profile p = follow_straight(direction, width, clear);
        if (dot(p.offset, p.offset) < dot(nearest.offset, nearest.offset)) nearest = p;
    }
    if (least < near) return nothing;
    return nearest;
}
#endif

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    float width = window_at(pixel);
    vec4 here = texelFetch(features, pixel, 0);
    vec2 theta = direction_of(here.gb);
    Profile p = nothing;
    if (theta != vec2(0.0)) p = look_along(theta, width);
#ifdef JUNCTIONS
    if (!p.found) p = look_around(width);
#endif
    out_profile = p.found ? vec4(p.offset, p.height, min(p.curvature, 6e4)) : vec4(1e4, 1e4, 0.0, 0.0);
}
