// The lights of the frame in world space; runtime/scene/view_uniforms.h fills it.
#include "common/view.glsl"

const int MAX_LIGHTS = 16;

struct LightData {
    vec4 position;  // place (point, spot), or direction towards the light with w = 0 (directional)
    vec4 direction; // xyz: where a spot points; w: range, 0 for no limit
    vec4 color;     // rgb: colour times intensity relative to the strongest light; w: 1 for a spot
    vec4 cone;      // x: cosine of the inner angle, y: of the outer angle; z: 1 for a light that turns with the gaze
};

layout(std140, binding = 1) uniform Lights {
    LightData lights[MAX_LIGHTS];
    int light_count;
};

// What the frame's lights do is known when the program is compiled (runtime/scene/light_defines.h): how many there are,
// LIGHTS_END where some end by range or cone, LIGHTS_GAZE where some turn with the gaze. Without the first, it is dynamic.
#ifndef LIGHT_COUNT
#define LIGHT_COUNT light_count
#define LIGHTS_END
#define LIGHTS_GAZE
#endif

// Turns a vector as the smallest turn takes the camera's axis to the line of sight to a point. What is perpendicular to
// the axis becomes perpendicular to the line of sight.
vec3 turn_with_gaze(vec3 v, vec3 world) {
    vec3 axis = vec3(view_from_world[0][2], view_from_world[1][2], view_from_world[2][2]);
    vec3 sight = towards_eye(world);
    vec3 sum = axis + sight;
    return v - dot(v, sum) / (1.0 + dot(axis, sight)) * sum + 2.0 * dot(v, axis) * sight;
}

// Unit vector from a point of the world towards light i.
vec3 towards_light(int i, vec3 world) {
    vec3 l = normalize(lights[i].position.xyz - lights[i].position.w * world);
#ifdef LIGHTS_GAZE
    if (lights[i].cone.z > 0.0) l = turn_with_gaze(l, world);
#endif
    return l;
}

// How much of light i reaches a point, from 0 to 1, without a jump: the end of its range and a spot's cone, as
// KHR_lights_punctual has them. Distance by itself dims nothing: tones are relative.
float light_reach(int i, vec3 world) {
#ifndef LIGHTS_END
    return 1.0;
#else
    LightData light = lights[i];
    if (light.position.w == 0.0) return 1.0;
    vec3 away = world - light.position.xyz;
    float reach = 1.0;
    if (light.direction.w > 0.0) {
        vec3 share = away / light.direction.w;
        float square = dot(share, share);
        reach = clamp(1.0 - square * square, 0.0, 1.0);
    }
    if (light.color.w > 0.0) {
        float inside = dot(normalize(away), light.direction.xyz) - light.cone.y;
        inside = clamp(inside / max(light.cone.x - light.cone.y, 1e-6), 0.0, 1.0);
        reach *= inside * inside;
    }
    return reach;
#endif
}
