#version 450 core
// Place on the surface at rest, of the surface that the depth buffer shows.
#include "common/view.glsl"
#include "implicit_brush/visible.glsl"

uniform uint object_seed;
uniform float radius_metres;

in vec3 place; // in radii of the object

layout(location = 0) out vec4 out_place;
layout(location = 1) out uvec2 out_object;

void main() {
    keep_visible();
    out_place = vec4(place, pixel_size / (gl_FragCoord.w * radius_metres));
    out_object = uvec2(object_seed, floatBitsToUint(radius_metres));
}
