// Whether a point of a line is in front of what is drawn around it, by probes of the surfaces: depth, and how it changes
// from pixel to pixel, PROBES of them per pixel and axis (shaders/edge_lines/probe.frag).
#ifdef PROBES
layout(binding = 0) uniform sampler2D probe_depth;
layout(binding = 1) uniform sampler2D probe_slope;
uniform vec2 probe_origin; // pixels: where the textures' lower left corner is in the picture

// Depth in the window is linear over a triangle, so that a probe knows how deep its triangle's plane is at the point
// itself. That is compared, and needs no tolerance for slanted surfaces: a point on the very plane passes, such as the
// foot of a wall on the ground; one a little behind a steep surface does not. What is left is rounding: of places on the
// screen to 1/256 pixel, and of depth. One probe of four is enough: then what hides the point ends between it and that
// probe, less than a probe's diagonal away.
bool visible(vec2 at, float depth) {
    vec2 place = (at - probe_origin) * float(PROBES) - 0.5;
    ivec2 last = textureSize(probe_depth, 0) - 1;
    ivec2 base = ivec2(floor(place));
    for (int i = 0; i < 4; ++i) {
        ivec2 texel = clamp(base + ivec2(i & 1, i >> 1), ivec2(0), last);
        float scene = texelFetch(probe_depth, texel, 0).r;
        vec2 slope = scene * texelFetch(probe_slope, texel, 0).rg;
        float plane = scene + dot(slope, place - vec2(texel));
        float tolerance = 0.02 * (abs(slope.x) + abs(slope.y)) + 2e-6 * scene;
        if (depth >= plane - tolerance) return true;
    }
    return false;
}
#endif
