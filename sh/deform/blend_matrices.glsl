// Linear blend skinning: a palette entry is the three rows of an affine matrix, and a vector that is not used. Needs
// deform/influences.glsl.

void blend(uint v, out vec4 rows[3]) {
    for (int r = 0; r < 3; ++r) rows[r] = vec4(0.0);
    for (uint i = v * uint(INFLUENCES); i < (v + 1u) * uint(INFLUENCES); ++i) {
        uint entry = entry_of(i);
        float weight = weight_of(i);
        for (uint r = 0u; r < 3u; ++r) rows[r] += weight * poses[entry + r];
    }
}
