#version 450 core
#include "surface/abstracted_vertex.glsl"

void main() { place_abstracted_vertex(); }
