#version 450 core
// The tone of a picture as that of a surface is: diffuse, not specular, with the width of its lines.
#include "abstracted_lines/widest_line.glsl"

layout(binding = 0) uniform sampler2D tones;
uniform float width; // px
layout(location = 0) out vec4 out_color;

void main() { out_color = vec4(texelFetch(tones, ivec2(gl_FragCoord.xy), 0).r, 0.0, width / widest_line, 1.0); }
