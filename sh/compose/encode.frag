#version 450 core
// The picture from float colour: the sRGB target of the framebuffer encodes what is written here.
layout(binding = 0) uniform sampler2D color;
layout(location = 0) out vec4 out_color;

void main() { out_color = vec4(clamp(texelFetch(color, ivec2(gl_FragCoord.xy), 0).rgb, 0.0, 1.0), 1.0); }
