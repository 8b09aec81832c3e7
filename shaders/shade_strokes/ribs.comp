#version 450 core
// Where the ribs of nodes are in the world, on the mesh as it is deformed now.
#include "shade_strokes/data.glsl"

layout(local_size_x = 64) in;

layout(std430, binding = 0) readonly buffer Indices { uint index[]; }
indices;
layout(std430, binding = 1) readonly buffer Nodes { Node node[]; }
nodes;
layout(std430, binding = 2) writeonly buffer Ribs { vec4 at[]; }
ribs;
layout(std430, binding = 3) readonly buffer Positions { float position[]; } // xyz, xyz, ...
positions;

uniform uint node_count;
uniform uint triangle_count;
uniform mat4 world_from_mesh;

vec3 vertex(uint index) {
    return vec3(positions.position[3u * index], positions.position[3u * index + 1u], positions.position[3u * index + 2u]);
}

void main() {
    uint n = gl_GlobalInvocationID.x;
    if (n >= node_count) return;
    for (int k = 0; k < RIB_POINTS; ++k) {
        uint triangle = min(nodes.node[n].rib[3 * k], triangle_count - 1u);
        float u = uintBitsToFloat(nodes.node[n].rib[3 * k + 1]), v = uintBitsToFloat(nodes.node[n].rib[3 * k + 2]);
        vec3 place = (1.0 - u - v) * vertex(indices.index[3u * triangle]) +
                     u * vertex(indices.index[3u * triangle + 1u]) + v * vertex(indices.index[3u * triangle + 2u]);
        float side = k == 1 ? nodes.node[n].bend[0] : k == 3 ? nodes.node[n].bend[1] : 0.5 * float(k) - 1.0;
        ribs.at[n * RIB_POINTS + k] = vec4((world_from_mesh * vec4(place, 1.0)).xyz, side);
    }
}
