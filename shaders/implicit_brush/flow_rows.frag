#version 450 core
// Terms of the least squares, added up over the window along rows.
#include "implicit_brush/flow.glsl"

layout(binding = 0) uniform sampler2D slopes;
layout(binding = 1) uniform sampler2D changes;
layout(binding = 2) uniform sampler2D weights;

layout(location = 0) out vec4 slope_sums;
layout(location = 1) out vec4 change_sums;
layout(location = 2) out float weight_sum;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    int outermost = textureSize(slopes, 0).x - 1;
    slope_sums = change_sums = vec4(0.0);
    weight_sum = 0.0;
    for (int i = -window_reach; i <= window_reach; ++i) {
        ivec2 place = ivec2(clamp(pixel.x + i, 0, outermost), pixel.y);
        slope_sums += window[abs(i)] * texelFetch(slopes, place, 0);
        change_sums += window[abs(i)] * texelFetch(changes, place, 0);
        weight_sum += window[abs(i)] * texelFetch(weights, place, 0).x;
    }
}
