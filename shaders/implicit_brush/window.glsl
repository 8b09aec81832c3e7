// Half the length of a profile at a pixel. Define: WORLD_WINDOW where it is in metres of what is seen.
#ifdef WORLD_WINDOW
#include "common/view.glsl"
layout(binding = 2) uniform sampler2D window_depths; // the depth buffer
uniform float window; // metres

const float widest_window = 64.0, narrowest_window = 1.5; // px: what can be looked through, and what there is to see

float window_at(ivec2 pixel) {
    float depth = texelFetch(window_depths, pixel, 0).r;
    float footprint = pixel_size * (eye.w > 0.0 && depth > 0.0 ? view_depth(depth) : 1.0);
    return depth > 0.0 ? clamp(window / footprint, narrowest_window, widest_window) : narrowest_window;
}
#else
uniform float window; // px

float window_at(ivec2 pixel) { return window; }
#endif
