// A picture as pixels of the view see it: the mean over a pixel where texels are smaller, between texels where they are
// larger. Where they are alike it is the texel, exactly.

uniform ivec2 place; // pixel of the view at the picture's lower left corner
uniform vec2 texels; // that a pixel spans

// How much a texel counts in the mean over [low, high], in texels.
float texel_weight(int texel, float low, float high) {
    float at = float(texel);
    if (high - low >= 1.0) return clamp(min(high, at + 1.0) - max(low, at), 0.0, 1.0);
    return max(0.0, 1.0 - abs(at + 0.5 - 0.5 * (low + high)));
}

// `grown`: pixels on each side that count, too. Past the picture's edge its outermost texels go on.
vec4 picture_mean(sampler2D source, float grown) {
    vec2 pixel = floor(gl_FragCoord.xy) - vec2(place);
    vec2 low = (pixel - grown) * texels, high = (pixel + 1.0 + grown) * texels;
    vec2 middle = 0.5 * (low + high);
    ivec2 first = ivec2(floor(min(low, middle - 0.5))), last = ivec2(ceil(max(high, middle + 0.5))) - 1;
    ivec2 outermost = textureSize(source, 0) - 1;
    vec4 sum = vec4(0.0);
    float weights = 0.0;
    for (int y = first.y; y <= last.y; ++y) {
        float row = texel_weight(y, low.y, high.y);
        if (row <= 0.0) continue;
        for (int x = first.x; x <= last.x; ++x) {
            float weight = row * texel_weight(x, low.x, high.x);
            sum += weight * texelFetch(source, clamp(ivec2(x, y), ivec2(0), outermost), 0);
            weights += weight;
        }
    }
    return sum / weights;
}
