#version 450 core
#include "surface/abstracted_vertex.glsl"

#ifdef WIDTH_FACTORS_UNIT
// By vertex, row after row (runtime/scene/vertex_textures.h): what the mesh leaves of the width of lines.
layout(binding = WIDTH_FACTORS_UNIT) uniform sampler2D width_factors;
out float width_factor;
#endif

void main() {
    place_abstracted_vertex();
#ifdef WIDTH_FACTORS_UNIT
    int columns = textureSize(width_factors, 0).x;
    width_factor = texelFetch(width_factors, ivec2(gl_VertexID % columns, gl_VertexID / columns), 0).x;
#endif
}
