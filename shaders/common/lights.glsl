// The lights of the frame in world space; runtime/scene/view_uniforms.h fills it.
const int MAX_LIGHTS = 16;

struct LightData {
    vec4 position;  // place (point, spot), or direction towards the light with w = 0 (directional)
    vec4 direction; // xyz: where a spot points; w: range, 0 for no limit
    vec4 color;     // rgb: colour times intensity relative to the strongest light; w: 1 for a spot
    vec4 cone;      // x: cosine of the inner angle, y: of the outer angle
};

layout(std140, binding = 1) uniform Lights {
    LightData lights[MAX_LIGHTS];
    int light_count;
};

// Unit vector from a point of the world towards light i.
vec3 towards_light(int i, vec3 world) {
    return normalize(lights[i].position.xyz - lights[i].position.w * world);
}
