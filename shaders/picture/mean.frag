#version 450 core
// A picture's tone or colour at the size of the view, for those who look at its pixels.
#include "picture/mean.glsl"

layout(binding = 0) uniform sampler2D source;
layout(location = 0) out vec4 color;

void main() { color = picture_mean(source, 0.0); }
