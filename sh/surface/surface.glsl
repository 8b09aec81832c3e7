// What every fragment shader of a surface shares: inputs, material, and the outputs that this frame's view asks for.
#include "common/view.glsl"

in vec3 world_position;
in vec3 world_normal;

uniform vec4 base_color;
uniform float alpha_cutoff;
uniform uint object_id;
#ifdef BASE_COLOR_TEXTURE
in vec2 texcoord;
layout(binding = 0) uniform sampler2D base_color_texture;
#endif
#ifdef NORMAL_MAP
in vec4 world_tangent;
in vec2 normal_texcoord;
layout(binding = 1) uniform sampler2D normal_map;
uniform float normal_scale;
#endif
#ifdef VERTEX_COLOR
in vec4 vertex_color;
#endif

layout(location = 0) out vec4 out_color;
#ifdef OUT_NORMAL
layout(location = 1) out vec4 out_normal;
#endif
#ifdef OUT_OBJECT_ID
layout(location = 2) out uint out_object_id;
#endif
#ifdef OUT_CODE
#include "surface/surface_code.glsl"
layout(location = 3) out uvec2 out_code;
#endif

// k_d of the paper: the material's colour here. Fragments below the cut-off are dropped.
vec3 surface_color() {
    vec4 color = base_color;
#ifdef BASE_COLOR_TEXTURE
    color *= texture(base_color_texture, texcoord);
#endif
#ifdef VERTEX_COLOR
    color *= vertex_color;
#endif
#ifdef ALPHA_MASK
    if (color.a < alpha_cutoff) discard;
#endif
    return color.rgb;
}

#ifdef NORMAL_MAP
// MikkTSpace: interpolated vectors are used as they are, and the bitangent is made here; glTF's maps are green up.
vec3 mapped_normal() {
    vec3 texel = texture(normal_map, normal_texcoord).xyz * 2.0 - 1.0;
    vec3 bitangent = world_tangent.w * cross(world_normal, world_tangent.xyz);
    vec3 normal = normal_scale * (texel.x * world_tangent.xyz + texel.y * bitangent) + texel.z * world_normal;
    float square = dot(normal, normal);
    return square > 1e-12 ? normal * inversesqrt(square) : normalize(world_normal);
}
#endif

// Whether a double-sided surface is seen from the side that its normals point away from.
bool seen_from_behind() {
#ifndef DOUBLE_SIDED
    return false;
#elif defined(MIRRORED)
    return gl_FrontFacing;
#else
    return !gl_FrontFacing;
#endif
}

// The unit normal on the side that is seen, with the normal map's relief. Seen from behind, a bump is a dent.
vec3 surface_normal() {
#ifdef NORMAL_MAP
    vec3 normal = mapped_normal();
#else
    vec3 normal = normalize(world_normal);
#endif
    return seen_from_behind() ? -normal : normal;
}

void write_surface(vec3 color, vec3 normal) {
    out_color = vec4(color, 1.0);
#ifdef OUT_NORMAL
    out_normal = vec4(normal, 1.0);
#endif
#ifdef OUT_OBJECT_ID
    out_object_id = object_id;
#endif
#ifdef OUT_CODE
    out_code = uvec2(object_id, encode_normal(normal));
#endif
}
