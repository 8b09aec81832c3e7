#version 450 core
// Normals in the world, for who looks closer than pixels do.
#include "surface/surface.glsl"

void main() {
    surface_color(); // drops what a material's mask cuts out
    out_color = vec4(surface_normal(), 1.0);
}
