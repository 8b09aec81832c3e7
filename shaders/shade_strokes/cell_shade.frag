#version 450 core
// AOVs `shade_needed` and `shade_delivered`: the shade of the cell that a pixel's surface lies in. Which atom of a
// triangle that is, is as ShadeCells::atom_at has it (systems/shade_strokes/shade_cells.cpp).

layout(binding = 0) uniform sampler2D depth_buffer;
// Per triangle: its first atom, and into how many parts its edges are divided; 0 for triangles without strokes.
layout(std430, binding = 0) readonly buffer Triangles { uvec2 triangles[]; };
layout(std430, binding = 1) readonly buffer Cells { uint cell_of_atom[]; };
layout(std430, binding = 2) readonly buffer Shade { float shade[]; }; // per cell

in vec3 weight;
flat in uint triangle;
layout(location = 0) out float out_shade;

uint atom_at(uint first, uint parts) {
    vec2 place = clamp(weight.yz, 0.0, 1.0) * float(parts);
    uint i = min(uint(place.x), parts - 1u);
    uint j = min(uint(place.y), parts - 1u - i);
    bool upper = place.x - float(i) + place.y - float(j) > 1.0 && i + j + 1u < parts;
    return first + i * (2u * parts - i) + 2u * j + (upper ? 1u : 0u);
}

void main() {
    float shown = texelFetch(depth_buffer, ivec2(gl_FragCoord.xy), 0).r;
    // Other programs may round depths differently in their last bits.
    if (abs(gl_FragCoord.z - shown) > 1e-5 * max(shown, 1e-6) + 1e-9) discard;
    uvec2 of = triangles[triangle];
    if (of.y == 0u) discard;
    out_shade = shade[cell_of_atom[atom_at(of.x, of.y)]];
}
