// Morph targets. Displacements are sorted by vertex: one invocation then sums what moves its vertex, in the order of the
// targets, without atomics and in one dispatch for any number of targets, sparse or dense.

// Three tables (positions, normals, tangents) of vertex_count + 1 places: the displacements of vertex v are from place
// v on to place v + 1. A displacement is 4 words: its target, x, y, z.
layout(std430, binding = 5) readonly buffer Morphs { uint morphs[]; };

uniform uint first_weight; // into `poses`; four weights to a vector

// `base` and the weighted displacements of table `kind`.
vec3 morphed(uint kind, uint v, vec3 base) {
    uint row = kind * (vertex_count + 1u) + v;
    uint end = morphs[row + 1u];
    vec3 sum = base;
    for (uint at = morphs[row]; at < end; at += 4u) {
        uint target = morphs[at];
        float weight = poses[first_weight + target / 4u][target % 4u];
        if (weight != 0.0)
            sum += weight * uintBitsToFloat(uvec3(morphs[at + 1u], morphs[at + 2u], morphs[at + 3u]));
    }
    return sum;
}

// `value` made unit, or `base` where nothing is left of it.
vec3 unit_or(vec3 value, vec3 base) {
    float square = dot(value, value);
    return square > 1e-12 && square < 1e30 ? value / sqrt(square) : base;
}
