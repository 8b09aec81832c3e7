#version 450 core
// Terms of the least squares, added up along columns, and their solution: motion m + c for which g . c = d + b, with b
// a change of brightness of the whole window, which falls out when the terms are taken about their means.
#include "implicit_brush/flow.glsl"

layout(binding = 0) uniform sampler2D slopes;
layout(binding = 1) uniform sampler2D changes;
layout(binding = 2) uniform sampler2D weights;
layout(binding = 3) uniform sampler2D flow;

layout(location = 0) out vec2 motion;

// Motion along which tone (in deviations, flow_even.frag) changes less than by so much a pixel, or than so much of what
// it changes by across, stays what it was.
const float least_slope = 7e-3; // squared
const float damping = 0.01;
// Pixels that one step may lead to.
const float longest_step = 2.0;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    int outermost = textureSize(slopes, 0).y - 1;
    vec4 s = vec4(0.0), c = vec4(0.0);
    float w = 1e-6;
    for (int i = -window_reach; i <= window_reach; ++i) {
        ivec2 place = ivec2(pixel.x, clamp(pixel.y + i, 0, outermost));
        s += window[abs(i)] * texelFetch(slopes, place, 0);
        c += window[abs(i)] * texelFetch(changes, place, 0);
        w += window[abs(i)] * texelFetch(weights, place, 0).x;
    }
    s /= w;
    c /= w;
    vec2 mean = vec2(s.w, c.w);
    vec3 a = s.xyz - vec3(mean.x * mean.x, mean.x * mean.y, mean.y * mean.y);
    a.xz += least_slope + damping / (w * w) * (a.x + a.z);
    vec2 b = c.xy - mean * c.z;
    vec2 step = vec2(a.z * b.x - a.y * b.y, a.x * b.y - a.y * b.x) / (a.x * a.z - a.y * a.y);
    motion = known_flow(flow) + step * min(1.0, longest_step / max(length(step), 1e-9));
#ifdef FULL_SIZE
    motion *= 2.0; // the finest level has half the size
#endif
}
