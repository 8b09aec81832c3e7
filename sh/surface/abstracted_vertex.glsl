// The surface's vertex, with the normal of the abstracted shape beside its own where ABSTRACTED asks for it
// (Barla et al. 2006, section 4). NORMALS_UNIT is that of the texture.
#include "surface/vertex.glsl"

#ifdef ABSTRACTED
// By vertex, row after row (runtime/scene/vertex_textures.h).
layout(binding = NORMALS_UNIT) uniform sampler2D abstracted_normals;
out vec3 abstracted_normal;
#endif

void place_abstracted_vertex() {
    place_vertex();
#ifdef ABSTRACTED
    int columns = textureSize(abstracted_normals, 0).x;
    vec3 normal = texelFetch(abstracted_normals, ivec2(gl_VertexID % columns, gl_VertexID / columns), 0).xyz;
    abstracted_normal = normalize(world_from_normal * normal);
#endif
}
