#version 450 core
// Lays a premultiplied layer over the picture; blending does the rest.
layout(binding = 0) uniform sampler2D layer;
layout(location = 0) out vec4 out_color;

void main() { out_color = texelFetch(layer, ivec2(gl_FragCoord.xy), 0); }
