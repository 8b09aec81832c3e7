#version 450 core
// One of the maps of a feature, for who asks for it as numbers.
layout(binding = 0) uniform sampler2D features; // height, direction twice around, singularity
layout(binding = 1) uniform sampler2D profiles; // from the pixel to the line, px; height; curvature

layout(location = 0) out vec2 out_map;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec4 feature = texelFetch(features, pixel, 0), profile = texelFetch(profiles, pixel, 0);
    bool found = profile.z > 0.0 && abs(profile.x) < 1e3;
#if defined(HEIGHT)
    out_map = feature.xx;
#elif defined(DIRECTION)
    float angle = 0.5 * atan(feature.z, feature.y);
    out_map = dot(feature.yz, feature.yz) > 1e-12 ? vec2(cos(angle), sin(angle)) : vec2(0.0);
#elif defined(SINGULARITY)
    out_map = feature.ww;
#elif defined(DISTANCE)
    out_map = vec2(found ? length(profile.xy) : 1e10);
#elif defined(LINE_HEIGHT)
    out_map = vec2(found ? profile.z : 0.0);
#elif defined(CURVATURE)
    out_map = vec2(found ? profile.w : 0.0);
#endif
}
