#version 450 core
// What each pixel near a line stamps: how much it counts, where its stamp lies, how large, how turned, in what colour
// (Vergne et al. 2011, section 4.1). Pixels that count for nothing are left as they are, zero.
#include "common/view.glsl"
#include "implicit_brush/brush_style.glsl"
#include "implicit_brush/direction.glsl"

layout(binding = 0) uniform sampler2D profiles; // from the pixel to the line, px; height; curvature
layout(binding = 1) uniform sampler2D features; // height, direction twice around, singularity
layout(binding = 2) uniform sampler2D depths;
#ifdef OWNERS
layout(binding = 3) uniform usampler2D object_ids;
layout(std430, binding = 0) readonly buffer Owners { uint owners[]; };
uniform uint owner_words, owner_bit; // of an object id: how many words, and the bit among them
#endif
#ifdef SURFACE_COLOR
layout(binding = 4) uniform sampler2D colors;
#endif
#ifdef NOISE
layout(binding = 5) uniform sampler2D noises; // four of them, each even over [-1, 1]
#endif

layout(location = 0) out vec4 out_place; // of the stamp's middle, from the pixel's; radius; px; angle
layout(location = 1) out vec4 out_ink;   // colour times weight; weight

ivec2 inside(ivec2 pixel) { return clamp(pixel, ivec2(0), textureSize(profiles, 0) - 1); }

// The pixel that shows what a line belongs to: of an occluding contour, what is before.
ivec2 anchor_of(vec2 line) {
#ifdef CONTOURS
    ivec2 corner = ivec2(floor(line - 0.5));
    ivec2 best = inside(corner);
    float nearest = texelFetch(depths, best, 0).r;
    for (int i = 1; i < 4; ++i) {
        ivec2 pixel = inside(corner + ivec2(i & 1, i >> 1));
        float depth = texelFetch(depths, pixel, 0).r;
        if (depth > nearest) best = pixel, nearest = depth;
    }
    return best;
#else
    return inside(ivec2(floor(line)));
#endif
}

// Across the line, unit: theta there. Orientations are averaged as directions twice around.
vec2 across_of(vec2 line) {
    vec2 place = line - 0.5;
    ivec2 corner = ivec2(floor(place));
    vec2 part = place - vec2(corner), sum = vec2(0.0);
    for (int i = 0; i < 4; ++i) {
        ivec2 step = ivec2(i & 1, i >> 1);
        vec2 weight = mix(1.0 - part, part, vec2(step));
        sum += weight.x * weight.y * texelFetch(features, inside(corner + step), 0).yz;
    }
    vec2 theta = direction_of(sum);
    return theta != vec2(0.0) ? theta : vec2(1.0, 0.0);
}

// Moves along an axis whose sign means nothing: towards the upper right.
vec2 towards_upper_right(vec2 axis, float by) { return by * axis * dot(axis, vec2(0.70710678)); }

bool owned(ivec2 anchor) {
#ifdef OWNERS
    uint at = texelFetch(object_ids, anchor, 0).r * owner_words + (owner_bit >> 5u);
    return at < uint(owners.length()) && (owners[at] >> (owner_bit & 31u) & 1u) != 0u;
#else
    return true;
#endif
}

// Pixels of a length of 1 there.
float unit_at(ivec2 anchor) {
    if (style.scale.y == 0.0) return 1.0;
    float depth = eye.w > 0.0 ? view_depth(texelFetch(depths, anchor, 0).r) : 1.0;
    return 1.0 / (pixel_size * clamp(depth, 1e-6, 1e9));
}

// How much of a line that is interrupted in a part of its length is left where noise is `even` in [0, 1].
float left_of(float even, float interrupted) {
    if (interrupted <= 0.0) return 1.0;
    const float soft = 0.08;
    float edge = mix(-soft, 1.0 + soft, interrupted);
    return smoothstep(edge - soft, edge + soft, even);
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec4 profile = texelFetch(profiles, pixel, 0);
    float height = profile.z, curvature = profile.w;
    if (!(height > 0.0 && abs(profile.x) < 1e3 && abs(profile.y) < 1e3)) discard;
    float peak = driven(style.peak, style.drivers.x, height, curvature);
    if (peak < style.scale.x || peak <= 0.0) discard;
    vec2 line = gl_FragCoord.xy + profile.xy;
    ivec2 anchor = anchor_of(line);
    if (!owned(anchor)) discard;
    vec4 noise = vec4(0.0);
#ifdef NOISE
    noise = clamp(texelFetch(noises, anchor, 0), -1.0, 1.0);
#endif
    vec4 even = 0.5 + 0.5 * noise;
    peak *= left_of(even.y, style.noise.x);
    float unit = unit_at(anchor);
    float spread = max(unit * driven(style.spread, style.drivers.y, height, curvature), LEAST_SPREAD);
    float weight = peak * exp(-0.5 * dot(profile.xy, profile.xy) / (spread * spread));
    if (weight < style.scale.x || weight <= 0.0) discard;
    float radius = unit * driven(style.size, style.drivers.z, height, curvature) * (1.0 - style.noise.w * even.x);
    radius = min(radius, style.scale.z);
    if (radius <= 0.0) discard;

    vec2 across = vec2(1.0, 0.0), shift = vec2(0.0);
    float angle = style.weak_color.w;
    bool shifted = style.choices.z != 0.0 || style.choices.w != 0.0;
    if (style.choices.x > 0.0 || shifted) across = across_of(line);
    vec2 along = vec2(-across.y, across.x);
    if (style.choices.x == turned_along) angle += atan(along.y, along.x);
    if (style.choices.x == turned_across) angle += atan(across.y, across.x);
    angle += style.noise.z * noise.z;
    if (shifted) shift = towards_upper_right(along, style.choices.z) + towards_upper_right(across, style.choices.w);
    shift += style.noise.y * noise.zw;

    vec3 color = style.color.rgb;
    if (style.choices.y == colored_by_profile)
        color = mix(style.weak_color.rgb, color, driven(style.tint, style.drivers.w, height, curvature));
#ifdef SURFACE_COLOR
    color = texelFetch(colors, anchor, 0).rgb;
#endif
    color = mix(color, style.weak_color.rgb, style.color.w * even.w);

    out_place = vec4(radius * shift, radius, angle);
    out_ink = vec4(color * weight, weight);
}
