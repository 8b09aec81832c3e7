// The texture `surface_code`: object id, and the normal folded onto an octahedron's net, 16 bits an axis, in one texel.

uint encode_normal(vec3 n) {
    vec2 p = n.xy / (abs(n.x) + abs(n.y) + abs(n.z));
    if (n.z < 0.0) p = (1.0 - abs(p.yx)) * mix(vec2(-1.0), vec2(1.0), greaterThanEqual(p, vec2(0.0)));
    return packSnorm2x16(p);
}

// Of no particular length.
vec3 decode_direction(uint code) {
    vec2 p = unpackSnorm2x16(code);
    vec3 n = vec3(p, 1.0 - abs(p.x) - abs(p.y));
    float below = max(-n.z, 0.0);
    n.xy -= mix(vec2(-below), vec2(below), greaterThanEqual(n.xy, vec2(0.0)));
    return n;
}
