#version 450 core
// Vertex stage of everything that is drawn from a mesh.
#include "surface/vertex.glsl"

void main() { place_vertex(); }
