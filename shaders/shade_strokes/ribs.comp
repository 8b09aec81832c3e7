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
#ifdef NARROWED
#include "shade_strokes/narrow.glsl"
layout(std430, binding = 4) readonly buffer Shares { float share[]; } // of their amplitude that strokes keep, by vertex
shares;
#endif

uniform uint node_count;
uniform uint triangle_count;
uniform mat4 world_from_mesh;

vec3 vertex(uint index) {
    uint at = 3u * index;
    return vec3(positions.position[at], positions.position[at + 1u], positions.position[at + 2u]);
}

#ifdef NARROWED
// Of a node: that of its middle, as stroke_narrowing.h has it.
float share_of(uint n) {
    const int middle = 3 * (RIB_POINTS / 2);
    uint corner = 3u * min(nodes.node[n].rib[middle], triangle_count - 1u);
    float u = uintBitsToFloat(nodes.node[n].rib[middle + 1]), v = uintBitsToFloat(nodes.node[n].rib[middle + 2]);
    float share = shares.share[indices.index[corner]];
    return share + u * (shares.share[indices.index[corner + 1u]] - share) +
           v * (shares.share[indices.index[corner + 2u]] - share);
}
#endif

void main() {
    uint n = gl_GlobalInvocationID.x;
    if (n >= node_count) return;
    vec4 rib[RIB_POINTS];
    for (int k = 0; k < RIB_POINTS; ++k) {
        uint triangle = min(nodes.node[n].rib[3 * k], triangle_count - 1u);
        float u = uintBitsToFloat(nodes.node[n].rib[3 * k + 1]), v = uintBitsToFloat(nodes.node[n].rib[3 * k + 2]);
        uvec3 corner = 3u * triangle + uvec3(0u, 1u, 2u);
        vec3 place = (1.0 - u - v) * vertex(indices.index[corner.x]) + u * vertex(indices.index[corner.y]) +
                     v * vertex(indices.index[corner.z]);
        float side = k == 1 ? nodes.node[n].bend[0] : k == 3 ? nodes.node[n].bend[1] : 0.5 * float(k) - 1.0;
        rib[k] = vec4((world_from_mesh * vec4(place, 1.0)).xyz, side);
    }
#ifdef NARROWED
    narrow(rib, share_of(n));
#endif
    for (int k = 0; k < RIB_POINTS; ++k) ribs.at[n * RIB_POINTS + k] = rib[k];
}
