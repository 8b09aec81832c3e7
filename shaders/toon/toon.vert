#version 450 core
// The surface's vertex, with the normal of the abstracted shape beside its own where shading asks for it.
#include "surface/vertex.glsl"

#ifdef ABSTRACTED
// By vertex, row after row. By gl_VertexID and not as an attribute: shapes of all kinds, those that the GPU deforms
// too, are drawn with the vertex arrays that they have.
layout(binding = 3) uniform sampler2D abstracted_normals;
out vec3 abstracted_normal;
#endif

void main() {
    place_vertex();
#ifdef ABSTRACTED
    int columns = textureSize(abstracted_normals, 0).x;
    vec3 normal = texelFetch(abstracted_normals, ivec2(gl_VertexID % columns, gl_VertexID / columns), 0).xyz;
    abstracted_normal = normalize(world_from_normal * normal);
#endif
}
