// Normals and tangents by the linear part of what moves a vertex, as SkinJob documents and with its thresholds. Where
// SkinJob falls back on double for what is out of float's range, the matrix is scaled here, which no direction sees:
// double is slow or emulated on many GPUs.

// The rows without translation, the largest element 1; all zero where the matrix is.
void linear_part(vec4 rows[3], out vec3 linear[3]) {
    vec3 most = max(max(abs(rows[0].xyz), abs(rows[1].xyz)), abs(rows[2].xyz));
    float largest = max(max(most.x, most.y), most.z);
    float scale = largest > 1e-36 ? 1.0 / largest : 0.0;
    for (int r = 0; r < 3; ++r) linear[r] = rows[r].xyz * scale;
}

// By the cofactors; the rest pose's where a collapse leaves nothing. `mirrors`: the matrix turns inside out.
vec3 skinned_normal(vec3 linear[3], vec3 rest, out bool mirrors) {
    vec3 cofactors[3] = {cross(linear[1], linear[2]), cross(linear[2], linear[0]), cross(linear[0], linear[1])};
    vec3 moved = vec3(dot(cofactors[0], rest), dot(cofactors[1], rest), dot(cofactors[2], rest));
    float size = dot(linear[0], linear[0]) + dot(linear[1], linear[1]) + dot(linear[2], linear[2]);
    float moved_length = length(moved);
    // The stretch along the normal. Where it is nothing but rounding, its sign says nothing.
    float along = moved_length > 0.0 ? dot(linear[0], cofactors[0]) / moved_length : 0.0;
    mirrors = along < 0.0 && along * along > 1e-12 * size;
    if (!(moved_length > 1e-6 * size)) return rest;
    return (mirrors ? -moved : moved) / moved_length;
}

// The part of a direction beside the normal, made unit; false where there is none.
bool beside(vec3 direction, vec3 normal, out vec3 unit) {
    vec3 part = direction - dot(direction, normal) * normal;
    float part_length = length(part);
    if (!(part_length > 1e-3 * length(direction))) return false;
    unit = part / part_length;
    return true;
}

// What the matrix makes of it, else the rest pose's, else anything: the first that has a part beside the normal.
vec3 skinned_tangent(vec3 linear[3], vec3 rest, vec3 normal) {
    vec3 unit;
    if (beside(vec3(dot(linear[0], rest), dot(linear[1], rest), dot(linear[2], rest)), normal, unit)) return unit;
    if (beside(rest, normal, unit)) return unit;
    beside(abs(normal.x) < 0.6 ? vec3(1.0, 0.0, 0.0) : vec3(0.0, 1.0, 0.0), normal, unit);
    return unit;
}
