#version 450 core
// How much pixels count in a brush, as numbers.
layout(binding = 0) uniform sampler2D inks; // colour times weight; weight
layout(location = 0) out float out_weight;

void main() { out_weight = texelFetch(inks, ivec2(gl_FragCoord.xy), 0).a; }
