// A line is where the pixels at its middle see it. Where a ridge lies a line's width beside the foot of an edge, or a
// line ends, pixels do not decide alike what is theirs: those that claim a line elsewhere than the pixels there see it
// draw rows of dots beside lines, and blots at their ends.

// From where on pixels do not agree on a place, px across the line.
const float agreed = 0.3, apart = 0.6;

// How far the pixel there agrees with this one on a line at `offset`, 0 to 1; < 0 where it sees none of its kind.
float agreement_at(sampler2D found, ivec2 there, vec2 offset, vec2 across, float side) {
    ivec2 texel = clamp(ivec2(gl_FragCoord.xy) + there, ivec2(0), textureSize(found, 0) - 1);
    vec4 seen = texelFetch(found, texel, 0);
    if (seen.w <= 0.0 || seen.z * side <= 0.0) return -1.0;
    return 1.0 - smoothstep(agreed, apart, abs(dot(vec2(there) + seen.xy - offset, across)));
}

// Where lines cross, the pixel at the middle of one may see the other: then those further along it are asked.
float agreement_along(sampler2D found, ivec2 there, vec2 offset, vec2 across, float side) {
    float result = agreement_at(found, there, offset, across, side);
    vec2 along = vec2(-across.y, across.x);
    for (float way = 2.0; way <= 4.0 && result < 1.0; way += 2.0)
        for (float turn = -1.0; turn <= 1.0; turn += 2.0)
            result = max(result, agreement_at(found, there + ivec2(round(turn * way * along)),
                                              offset + turn * way * along, across, side));
    return result;
}

// `line`: from the pixel to the line's middle, px; signed curvature; opacity along it. Half of a line along an outline is
// hidden by what lies before it: then the pixel before its middle speaks for it.
float agreement(sampler2D found, vec4 line) {
    vec2 offset = line.xy;
    ivec2 there = ivec2(floor(offset + 0.5));
    if (line.w <= 0.0 || there == ivec2(0)) return 1.0;
    vec2 across = normalize(offset);
    float result = agreement_along(found, there, offset, across, line.z);
    if (result >= 0.0) return result;
    there = ivec2(floor(offset - 0.6 * across + 0.5));
    return there == ivec2(0) ? 1.0 : max(agreement_along(found, there, offset, across, line.z), 0.0);
}
