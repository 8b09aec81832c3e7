#version 450 core
// Vertex stage of Gooch's modes; the per-vertex ones are lit here, both sides where both are drawn.
#include "surface/vertex.glsl"
#ifdef PER_VERTEX
#include "gooch/lighting.glsl"

out vec3 front_light;
#ifdef PHONG
out vec3 front_shine;
#endif
#ifdef DOUBLE_SIDED
out vec3 back_light;
#ifdef PHONG
out vec3 back_shine;
#endif
#endif
#endif

void main() {
    place_vertex();
#ifdef PER_VERTEX
    vec3 n = normalize(world_normal);
#ifdef PHONG
    front_light = diffuse_light(world_position, n);
    front_shine = specular_light(world_position, n);
#ifdef DOUBLE_SIDED
    back_light = diffuse_light(world_position, -n);
    back_shine = specular_light(world_position, -n);
#endif
#else
    front_light = tone_light(world_position, n);
#ifdef DOUBLE_SIDED
    back_light = tone_light(world_position, -n);
#endif
#endif
#endif
}
