// What the passes of optical flow share; systems/implicit_brush/optical_flow.h.

// Between texels, at a place in texels whose first middle is at .5; past the edge the outermost texels go on. Texture
// units may do so in steps of 1/256, which is too coarse for what is accumulated.
vec4 between_texels(sampler2D source, vec2 place) {
    ivec2 outermost = textureSize(source, 0) - 1;
    vec2 p = clamp(place - 0.5, vec2(0.0), vec2(outermost));
    ivec2 low = ivec2(p), high = min(low + 1, outermost);
    vec2 t = p - vec2(low);
    return mix(mix(texelFetch(source, low, 0), texelFetch(source, ivec2(high.x, low.y), 0), t.x),
               mix(texelFetch(source, ivec2(low.x, high.y), 0), texelFetch(source, high, 0), t.x), t.y);
}

// Motion as it is known so far, in this level's pixels.
vec2 known_flow(sampler2D source) {
#ifdef AT_REST
    return vec2(0.0);
#elif defined(ENLARGE)
    // Smoothed a little by weights 1 2 1.
    vec2 place = 0.5 * gl_FragCoord.xy, sum = vec2(0.0);
    for (int i = 0; i < 4; ++i) sum += between_texels(source, place + vec2(i & 1, i >> 1) - 0.5).xy;
    return 0.5 * sum;
#else
    return texelFetch(source, ivec2(gl_FragCoord.xy), 0).xy;
#endif
}

// A window of 13 pixels, normal with a standard deviation of 3.
const int window_reach = 6;
const float window[window_reach + 1] =
    float[7](0.13702, 0.12962, 0.10972, 0.08311, 0.05633, 0.03417, 0.01854);
