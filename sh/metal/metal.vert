#version 450 core
// Hands on what stripes of metal are counted by; systems/metal/metal_surface.h sets it up.
#include "surface/vertex.glsl"

#ifdef AROUND_AXIS
uniform mat3 axis_from_entity; // its third row runs along the axis
uniform vec3 axis_point;
out vec2 about_axis;           // place in the plane across the axis
#else
layout(location = 6) in float in_coordinate; // sets
layout(location = 7) in vec4 in_frame;       // where the coordinate rises, and radians that the normal turns per set
layout(location = 8) in float in_weight;
#ifdef SMOOTH_NORMAL
layout(location = 9) in vec4 in_smooth_normal; // and radians per metre that it turns
layout(location = 10) in float in_clarity;
out vec3 world_smooth_normal;
out float clarity;
out float turning_per_metre;
#endif
out float coordinate;
out vec3 world_across;
out float turning;
out float weight;
#endif

void main() {
    place_vertex();
#ifdef AROUND_AXIS
    about_axis = (axis_from_entity * (in_position - axis_point)).xy;
#else
    coordinate = in_coordinate;
    world_across = world_from_normal * in_frame.xyz;
    turning = in_frame.w;
    weight = in_weight;
#ifdef SMOOTH_NORMAL
    world_smooth_normal = world_from_normal * in_smooth_normal.xyz;
    clarity = in_clarity;
    turning_per_metre = in_smooth_normal.w;
#endif
#endif
}
