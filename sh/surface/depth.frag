#version 450 core
// AOV `depth`: metres from the eye's plane; 1e10 where nothing is drawn, so that "nearer than" keeps its meaning.
#include "common/view.glsl"

layout(binding = 0) uniform sampler2D depth_buffer;
layout(location = 0) out float out_depth;

void main() {
    float depth = texelFetch(depth_buffer, ivec2(gl_FragCoord.xy), 0).r;
    out_depth = depth > 0.0 ? view_depth(depth) : 1e10;
}
