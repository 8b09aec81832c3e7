#version 450 core
// A piece of a stroke with round ends: coverage, and the ink of its texture.
#include "abstracted_lines/across.glsl"

layout(binding = 0) uniform sampler2D ink; // how much ink there is; mirrored along the stroke

flat in vec4 segment;
flat in vec2 half_widths;
flat in vec2 opacities;
flat in vec2 arcs;
flat in vec2 ends;
flat in vec3 ahead;
flat in vec3 weights;
flat in vec2 turn;

uniform vec3 color;
uniform float taper;            // over how many widths a stroke thins out towards its ends; 0: not at all
uniform float fade;             // as of lines that pixels draw
uniform float texture_strength; // 0: solid
uniform float texture_length;   // px, of the larger octave
uniform float octave_blend;     // 0: the larger alone, 1: the smaller
uniform float mean_ink;

layout(location = 0) out vec4 out_line;

// Difference from the mean, on both sides of the texture as far as it is turning over.
float ink_at(float along, float across, float length_, float width) {
    vec2 texels = vec2(textureSize(ink, 0)) / vec2(length_, max(width, 1.0));
    float level = max(log2(max(texels.x, texels.y)), 0.0);
    float left = turn.x < 1.0 ? textureLod(ink, vec2(along / length_, 0.5 - across), level).r : 0.0;
    float right = turn.x > 0.0 ? textureLod(ink, vec2(along / length_, 0.5 + across), level).r : 0.0;
    return mix(left, right, turn.x) - mean_ink;
}

// Several textures are blended so that their sum has the contrast of one.
float blended_ink(float arc, float across, float width) {
    float sum = 0.0, squares = 0.0;
    for (int axis = 0; axis < 3; ++axis) {
        if (weights[axis] < 0.01) continue;
        float along = arc + ahead[axis];
        if (turn.y > 0.0) { // both ways round a closed stroke, until they meet
            along = mod(along, turn.y);
            along = min(along, turn.y - along);
        }
        for (int octave = 0; octave < 2; ++octave) {
            float part = weights[axis] * (octave == 0 ? 1.0 - octave_blend : octave_blend);
            if (part < 0.01) continue;
            sum += part * ink_at(along, across, octave == 0 ? texture_length : 0.5 * texture_length, width);
            squares += part * part;
        }
    }
    return clamp(mean_ink + (squares > 0.0 ? sum * inversesqrt(squares) : 0.0), 0.0, 1.0);
}

void main() {
    vec2 start = segment.xy;
    vec2 along = segment.zw - start;
    vec2 offset = gl_FragCoord.xy - start;
    float square = max(dot(along, along), 1e-12);
    float t = clamp(dot(offset, along) / square, 0.0, 1.0);
    float away = distance(offset, t * along);
    float width = 2.0 * mix(half_widths.x, half_widths.y, t);
    float arc = mix(arcs.x, arcs.y, t);
    if (taper > 0.0) {
        float from_end = max(min(arc - ends.x, ends.y - arc), 0.0) / (width * taper);
        width *= sqrt(min(from_end, 1.0)); // a quill's end: round, not a needle
    }
    float coverage = across_width(away, width, fade) * mix(opacities.x, opacities.y, t);
    if (coverage <= 0.0) discard;
    float side = along.x * offset.y - along.y * offset.x >= 0.0 ? 1.0 : -1.0; // 1: left of the stroke
    float across = clamp(0.5 * side * away / max(0.5 * width, 0.5), -0.5, 0.5);
    coverage *= mix(1.0, blended_ink(arc, across, width), texture_strength);
    out_line = vec4(color, 1.0) * coverage;
}
