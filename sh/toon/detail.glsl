// The tone detail D of X-Toon (Barla et al. 2006, section 3), in [0, 1]. DETAIL is the ToonDetail.
uniform float detail_distance;
uniform float detail_log_ratio; // log r
uniform float detail_power;
uniform vec3 detail_focus;

// Distance from the eye; in an orthographic view, from its plane.
float eye_distance() {
    return eye.w > 0.0 ? distance(eye.xyz, world_position) : -(view_from_world * vec4(world_position, 1.0)).z;
}

float tone_detail(vec3 n, vec3 v) {
    float detail = 1.0;
#if DETAIL == 1
    detail = 1.0 - log(max(eye_distance(), 1e-9) / detail_distance) / detail_log_ratio;
#elif DETAIL == 2
    float z = -(view_from_world * vec4(world_position, 1.0)).z;
    detail = 1.0 - abs(log(max(z, 1e-9) / detail_distance)) / detail_log_ratio;
#elif DETAIL == 3
    detail = 1.0 - log(max(distance(detail_focus, world_position), 1e-9) / detail_distance) / detail_log_ratio;
#elif DETAIL == 4
    detail = pow(abs(dot(n, v)), detail_power);
#elif DETAIL == 5
    detail = LIGHT_COUNT > 0 ? pow(max(dot(v, reflect(-towards_light(0, world_position), n)), 0.0), detail_power) : 0.0;
#endif
    return clamp(detail, 0.0, 1.0);
}
