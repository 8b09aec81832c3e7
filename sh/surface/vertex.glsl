// What every vertex shader of a surface shares: the mesh's attributes, its place, and what surface/surface.glsl reads.
// runtime/scene/surface_renderer.h sets it up.
#include "common/view.glsl"

layout(location = 0) in vec3 in_position;
layout(location = 1) in vec3 in_normal;
layout(location = 2) in vec2 in_texcoord;
layout(location = 3) in vec4 in_color;
#ifdef NORMAL_MAP
layout(location = 4) in vec4 in_tangent;
#ifdef NORMAL_TEXCOORD
layout(location = 5) in vec2 in_normal_texcoord;
#else
#define in_normal_texcoord in_texcoord
#endif
uniform vec3 normal_texcoord_u; // rows of the affine map of (u, v, 1)
uniform vec3 normal_texcoord_v;
out vec4 world_tangent;
out vec2 normal_texcoord;
#endif

uniform mat4 world_from_entity;
uniform mat3 world_from_normal;
#ifdef BASE_COLOR_TEXTURE
uniform vec3 texcoord_u; // rows of the affine map of (u, v, 1)
uniform vec3 texcoord_v;
out vec2 texcoord;
#endif
#ifdef VERTEX_COLOR
out vec4 vertex_color;
#endif
out vec3 world_position;
out vec3 world_normal;

// Places the vertex and hands on what surface/surface.glsl reads.
void place_vertex() {
    vec4 world = world_from_entity * vec4(in_position, 1.0);
    world_position = world.xyz;
    world_normal = world_from_normal * in_normal;
#ifdef NORMAL_MAP
    // Of one length, as map and tangents are made for: the transform scales normals and tangents differently.
    world_normal = normalize(world_normal);
    world_tangent = vec4(normalize(mat3(world_from_entity) * in_tangent.xyz), in_tangent.w);
#ifdef MIRRORED
    world_tangent.w = -world_tangent.w; // the cross product keeps its hand where the surface changes its own
#endif
    vec3 normal_uv = vec3(in_normal_texcoord, 1.0);
    normal_texcoord = vec2(dot(normal_texcoord_u, normal_uv), dot(normal_texcoord_v, normal_uv));
#endif
#ifdef BASE_COLOR_TEXTURE
    vec3 uv = vec3(in_texcoord, 1.0);
    texcoord = vec2(dot(texcoord_u, uv), dot(texcoord_v, uv));
#endif
#ifdef VERTEX_COLOR
    vertex_color = in_color;
#endif
    gl_Position = clip_from_world * world;
}
