#version 450 core
// Surfaces that carry no material of a style: their plain colour.
#include "surface/surface.glsl"

void main() { write_surface(surface_color(), surface_normal()); }
