#version 450 core
// One of the buffers that features can be looked at as. Define: AOV, of `texel`; AOV_TYPE.
#include "implicit_brush/direction.glsl"

layout(binding = 0) uniform sampler2D textures;
layout(location = 0) out AOV_TYPE out_aov;

void main() {
    vec4 texel = texelFetch(textures, ivec2(gl_FragCoord.xy), 0);
    out_aov = AOV;
}
