#version 450 core
// One colour: the floor that frame times are compared with.
layout(location = 0) out vec4 out_color;

void main() { out_color = vec4(0.5, 0.5, 0.5, 1.0); }
