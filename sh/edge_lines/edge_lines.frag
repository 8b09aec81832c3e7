#version 450 core
// Coverage of a line with round ends, where the point of the line nearest to this pixel is visible. Testing the depth at
// the line itself, not at the pixel, keeps a line whole across its width: no dashes on slanted surfaces, no leaks where
// the rim of a line lies over something nearer.
#include "edge_lines/visible.glsl"

flat in vec4 segment;
flat in vec2 depths;
flat in vec2 half_widths;
flat in vec2 weights;
flat in vec2 arcs;
flat in vec2 ends;

uniform vec3 color;
uniform float taper;  // over how many widths a line thins out towards its ends; 0: not at all
uniform float dash;   // of how many widths a dash is, and the gap after it; 0: a solid line

layout(location = 0) out vec4 out_line;

// A box filter one pixel wide; a line thinner than a pixel keeps its width as opacity.
float covered(float half_width, float away) {
    return clamp(half_width - away + 0.5, 0.0, min(1.0, 2.0 * half_width));
}

void main() {
    vec2 start = segment.xy;
    vec2 along = segment.zw - start;
    vec2 offset = gl_FragCoord.xy - start;
    float t = clamp(dot(offset, along) / max(dot(along, along), 1e-12), 0.0, 1.0);
    float away = distance(offset, t * along);
    float half_width = mix(half_widths.x, half_widths.y, t);
    float arc = mix(arcs.x, arcs.y, t);
    if (taper > 0.0) {
        float from_end = max(min(arc - ends.x, ends.y - arc), 0.0) / (2.0 * half_width * taper);
        half_width *= sqrt(min(from_end, 1.0)); // a quill's end: round, not a needle
    }
    float coverage = covered(half_width, away);
    if (dash > 0.0) {
        float period = 4.0 * half_width * dash;
        float place = mod(arc, period);
        coverage *= clamp(0.25 * period - abs(place - 0.25 * period) + 0.5, 0.0, 1.0);
    }
    coverage *= mix(weights.x, weights.y, t);
    if (coverage <= 0.0) discard;
#ifdef PROBES
    bool seen = visible(start + t * along, mix(depths.x, depths.y, t));
#ifdef HIDDEN
    seen = !seen;
#endif
    if (!seen) discard;
#endif
    out_line = vec4(color, 1.0) * coverage;
}
