// The view of the frame; runtime/scene/view_uniforms.h fills it.
layout(std140, binding = 0) uniform View {
    mat4 view_from_world;
    mat4 clip_from_view;
    mat4 clip_from_world;
    vec4 eye;           // perspective: place of the eye, w = 1; orthographic: direction towards the eye, w = 0
    vec2 viewport;      // pixels
    float pixel_size;   // metres of one pixel at depth 1 (perspective) or at every depth (orthographic)
};

// Unit vector from a point of the world towards the eye.
vec3 towards_eye(vec3 world) { return normalize(eye.xyz - eye.w * world); }

// Distance from the eye's plane, metres, of a depth buffer value (reversed: 1 near, 0 far).
float view_depth(float depth) {
    return -(clip_from_view[3][2] - depth * clip_from_view[3][3]) /
           (depth * clip_from_view[2][3] - clip_from_view[2][2]);
}

// The depth buffer value of such a distance.
float window_depth(float metres) {
    return (metres * clip_from_view[2][2] - clip_from_view[3][2]) /
           (metres * clip_from_view[2][3] - clip_from_view[3][3]);
}
