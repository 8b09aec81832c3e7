#version 450 core
// Where each pixel of a picture was when noise was made: where it is, or where it was a frame ago and from there on by
// the map of that frame.
#include "implicit_brush/flow.glsl"

layout(binding = 0) uniform sampler2D map;
layout(binding = 1) uniform sampler2D flow; // of half the size

layout(location = 0) out vec2 place;

void main() {
#ifdef START
    place = gl_FragCoord.xy;
#else
    vec2 before = gl_FragCoord.xy - between_texels(flow, 0.5 * gl_FragCoord.xy).xy;
    // What came into the picture was beside it, where the map goes on.
    vec2 inside = clamp(before, vec2(0.5), vec2(textureSize(map, 0)) - 0.5);
    place = between_texels(map, inside).xy + before - inside;
#endif
}
