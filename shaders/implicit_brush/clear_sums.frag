#version 450 core

layout(location = 0) out uint out_sum;

void main() { out_sum = 0u; }
