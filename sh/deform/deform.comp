#version 450 core
// The shape of a skinned or morphing surface, a vertex per invocation, as MorphJob and then SkinJob of
// runtime/geometry/ make it. systems/deform/gpu_deformer.cpp sets it up.
// Defines: MORPH; SKIN, and with it INFLUENCES (4, 8), JOINT_BITS (8, 16, 32) and DUAL_QUATERNION; TANGENTS.
// Vectors of three floats lie one after the other, as vertex buffers have them, so they are read as floats.
layout(local_size_x = 64) in;

layout(std430, binding = 0) readonly buffer RestPositions { float rest_positions[]; };
layout(std430, binding = 1) readonly buffer RestNormals { float rest_normals[]; };
#ifdef TANGENTS
layout(std430, binding = 2) readonly buffer RestTangents { float rest_tangents[]; };
#endif
// The poses of all surfaces that are deformed in this frame: palettes, 4 vectors per entry, and weights of targets.
layout(std430, binding = 3) readonly buffer Poses { vec4 poses[]; };
// Positions of all vertices, their normals, their tangents.
layout(std430, binding = 6) writeonly buffer Shape { float shape[]; };

uniform uint vertex_count;

#ifdef MORPH
#include "deform/morph.glsl"
#endif
#ifdef SKIN
#include "deform/influences.glsl" // here: a file is included once, whatever #if it is in
#ifdef DUAL_QUATERNION
#include "deform/blend_motions.glsl"
#else
#include "deform/blend_matrices.glsl"
#endif
#include "deform/directions.glsl"
#endif

void write(uint at, vec3 value) {
    shape[at] = value.x;
    shape[at + 1u] = value.y;
    shape[at + 2u] = value.z;
}

void main() {
    // Meshes may have more vertices than groups fit in one row.
    uint v = (gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x) * gl_WorkGroupSize.x + gl_LocalInvocationID.x;
    if (v >= vertex_count) return;
    vec3 position = vec3(rest_positions[3u * v], rest_positions[3u * v + 1u], rest_positions[3u * v + 2u]);
    vec3 normal = vec3(rest_normals[3u * v], rest_normals[3u * v + 1u], rest_normals[3u * v + 2u]);
#ifdef TANGENTS
    vec3 tangent = vec3(rest_tangents[4u * v], rest_tangents[4u * v + 1u], rest_tangents[4u * v + 2u]);
    float hand = rest_tangents[4u * v + 3u];
#endif
#ifdef MORPH
    position = morphed(0u, v, position);
    normal = unit_or(morphed(1u, v, normal), normal);
#ifdef TANGENTS
    tangent = unit_or(morphed(2u, v, tangent), tangent);
#endif
#endif
#ifdef SKIN
    vec4 rows[3];
    blend(v, rows);
    position = vec3(dot(rows[0].xyz, position) + rows[0].w, dot(rows[1].xyz, position) + rows[1].w,
                    dot(rows[2].xyz, position) + rows[2].w);
    vec3 linear[3];
    linear_part(rows, linear);
    bool mirrors;
    normal = skinned_normal(linear, normal, mirrors);
#ifdef TANGENTS
    tangent = skinned_tangent(linear, tangent, normal);
    if (mirrors) hand = -hand;
#endif
#endif
    write(3u * v, position);
    write(3u * (vertex_count + v), normal);
#ifdef TANGENTS
    uint at = 6u * vertex_count + 4u * v;
    write(at, tangent);
    shape[at + 3u] = hand;
#endif
}
