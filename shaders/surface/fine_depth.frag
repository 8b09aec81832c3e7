#version 450 core
// Depth alone, for who looks closer than pixels do.
#include "surface/surface.glsl"

void main() {
    surface_color(); // drops what a material's mask cuts out
}
