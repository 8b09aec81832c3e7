#version 450 core

layout(location = 0) out vec4 out_sum;

void main() { out_sum = vec4(0.0); }
