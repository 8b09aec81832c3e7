// Dual quaternion skinning (Kavan et al. 2008): a palette entry is the real and the dual part, and the stretch that
// comes before them: xx, yy, zz; xy, xz, yz. Needs deform/influences.glsl.

// The matrix of a blended motion: rotation * stretch, and the translation 2 * dual * conjugate(real).
void motion_to_rows(vec4 q, vec4 d, vec3 diagonal, vec3 mixed, out vec4 rows[3]) {
    vec3 rotation[3] = {
        vec3(1.0 - 2.0 * (q.y * q.y + q.z * q.z), 2.0 * (q.x * q.y - q.w * q.z), 2.0 * (q.x * q.z + q.w * q.y)),
        vec3(2.0 * (q.x * q.y + q.w * q.z), 1.0 - 2.0 * (q.x * q.x + q.z * q.z), 2.0 * (q.y * q.z - q.w * q.x)),
        vec3(2.0 * (q.x * q.z - q.w * q.y), 2.0 * (q.y * q.z + q.w * q.x), 1.0 - 2.0 * (q.x * q.x + q.y * q.y))};
    mat3 stretch = mat3(diagonal.x, mixed.x, mixed.y, mixed.x, diagonal.y, mixed.z, mixed.y, mixed.z, diagonal.z);
    vec3 translation = 2.0 * (q.w * d.xyz - d.w * q.xyz + cross(q.xyz, d.xyz));
    for (int r = 0; r < 3; ++r) rows[r] = vec4(rotation[r] * stretch, translation[r]);
}

// A quaternion that points away from the vertex's first is negated, which is the same rotation on the shorter way
// (antipodality).
void blend(uint v, out vec4 rows[3]) {
    uint begin = v * uint(INFLUENCES);
    vec4 first = poses[entry_of(begin)];
    vec4 real = vec4(0.0), dual = vec4(0.0), diagonal = vec4(0.0), mixed = vec4(0.0);
    for (uint i = begin; i < begin + uint(INFLUENCES); ++i) {
        uint entry = entry_of(i);
        float weight = weight_of(i);
        float turned = dot(poses[entry], first) < 0.0 ? -weight : weight;
        real += turned * poses[entry];
        dual += turned * poses[entry + 1u];
        diagonal += weight * poses[entry + 2u];
        mixed += weight * poses[entry + 3u];
    }
    // The first weight is at least 1/8 and the others point its way, so the length is never near zero.
    float size = length(real);
    motion_to_rows(real / size, dual / size, diagonal.xyz, mixed.xyz, rows);
}
