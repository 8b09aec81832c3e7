#version 450 core
layout(binding = 0) uniform sampler2D tones;
layout(location = 0) out float out_tone;

void main() { out_tone = texelFetch(tones, ivec2(gl_FragCoord.xy), 0).g; }
