// What a tone looks like: bands, or a ramp from a file. Both are averaged over the pixel's width in closed form.
#ifdef RAMP
// Sums of the ramp's texels along its rows, over the number of columns: texel x of a row is the sum of those left of
// it, so that a row is one texel wider than the ramp. Row 0 is for no detail.
layout(binding = 2) uniform sampler2D ramp_sums;

// The integral of a row from 0 to `tone`. Texels are constant over their width; the outer ones go on for ever.
vec3 ramp_integral(float tone, int row) {
    int columns = textureSize(ramp_sums, 0).x - 1;
    float x = tone * float(columns);
    int column = int(clamp(floor(x), 0.0, float(columns - 1)));
    vec3 left = texelFetch(ramp_sums, ivec2(column, row), 0).rgb;
    vec3 right = texelFetch(ramp_sums, ivec2(column + 1, row), 0).rgb;
    return left + (x - float(column)) * (right - left);
}

vec3 ramp_mean(float low, float high, int row) {
    return (ramp_integral(high, row) - ramp_integral(low, row)) / (high - low);
}

uniform float softness;

vec3 tone_color(float tone, float width, float detail) {
    // The least width keeps the difference of sums exact to 1e-4.
    float half_width = 0.5 * max(max(width, softness), 1e-3);
    float low = tone - half_width, high = tone + half_width;
    int rows = textureSize(ramp_sums, 0).y;
    float y = clamp(detail * float(rows) - 0.5, 0.0, float(rows - 1));
    int row = int(y);
    return mix(ramp_mean(low, high, row), ramp_mean(low, high, min(row + 1, rows - 1)), y - float(row));
}
#else
#ifdef SOFT
uniform float softness;
#else
const float softness = 0.0;
#endif
uniform vec3 band_colors[BANDS]; // from the darkest to the lightest
uniform float band_edges[BANDS]; // where band i begins; that of band 0 is not looked at
uniform float middle_edge;

// Down to half of the detail the edges of bands move together to their middle, which leaves light and shade; from there
// on the shade fades.
vec3 tone_color(float tone, float width, float detail) {
    float apart = clamp(2.0 * detail - 1.0, 0.0, 1.0);
    vec3 color = band_colors[0];
    for (int i = 1; i < BANDS; ++i) {
        float edge = mix(middle_edge, band_edges[i], apart);
        color += filtered_step(tone - edge, width, softness) * (band_colors[i] - band_colors[i - 1]);
    }
    return mix(band_colors[BANDS - 1], color, min(2.0 * detail, 1.0));
}
#endif
