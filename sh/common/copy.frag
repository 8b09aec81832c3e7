#version 450 core
// Copies a texture of the target's size, texel by texel.

uniform sampler2D source;

layout(location = 0) out vec4 color;

void main() { color = texelFetch(source, ivec2(gl_FragCoord.xy), 0); }
