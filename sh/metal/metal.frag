#version 450 core
// Milled metal of Gooch 1998, section 4.3.
#include "surface/surface.glsl"
#include "common/lights.glsl"
#include "metal/ramp.glsl"
#include "metal/stripes.glsl"

uniform float light_stripe;
uniform float tint;
#ifdef COOL_TO_WARM
uniform float cool_to_warm;
uniform float b;
uniform float y;
uniform float alpha;
uniform float beta;
#endif

// What the white stripe faces: the light, or what is halfway between the light and the eye, as a highlight does.
// Along the gaze, not to the eye itself, so that the stripe is as straight as the streaks. It is shorter than 1 where the
// light comes from behind, and nothing is halfway.
vec3 faced_by_white(vec3 l) {
#ifdef HALFWAY
    vec3 backward = vec3(view_from_world[0].z, view_from_world[1].z, view_from_world[2].z);
    return l + backward;
#else
    return l;
#endif
}

void main() {
    vec3 stripe_color = mix(vec3(1.0), surface_color(), tint);
    vec3 n = surface_normal();
    vec3 l = towards_light(0, world_position);

    Stripes stripes = stripes_here(n, faced_by_white(l));
    Place at = place_of(stripes.x - 0.5); // the first stripe's centre is half a stripe from where its set begins
    float ramp = ramp_mean + stripes.weight * filtered_ramp(footprint_of(stripes.dx, stripes.dy, 1e5), at);
    vec3 color = stripe_color * ramp;
    // Past a whole turn every pixel holds the same white.
    Footprint turn = footprint_of(stripes.dx, stripes.dy, stripes.turn);
    if (light_is_near(turn, stripes.towards_light)) {
        vec2 white = light_stripe * light_weight(stripes) * filtered_light(turn, at, stripes.towards_light);
        color = stripe_color * (ramp - white.y) + white.x;
    }

#ifdef COOL_TO_WARM
    // The stripes are the object colour of equation 3, the weight that of equation 2.
    vec3 k_cool = vec3(0.0, 0.0, b) + alpha * color;
    vec3 k_warm = vec3(y, y, 0.0) + beta * color;
    color = mix(color, mix(k_cool, k_warm, 0.5 + 0.5 * dot(l, n)), cool_to_warm);
#endif
    write_surface(color, n);
}
