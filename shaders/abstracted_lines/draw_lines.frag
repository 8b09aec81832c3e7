#version 450 core
// Draws what lines.frag found, as far as other pixels agree.
layout(binding = 4) uniform sampler2D found_lines; // of diffuse and specular tone: from a pixel to its line's middle, px;
layout(binding = 5) uniform sampler2D specular_found_lines; // signed curvature, > 0 in a valley; opacity along the line
#ifdef STACK
#include "abstracted_lines/widest_line.glsl"
layout(binding = 3) uniform sampler2D widths; // blue: width times coverage, alpha: coverage
#endif

#include "abstracted_lines/style.glsl"
#include "abstracted_lines/across.glsl"
#include "abstracted_lines/agreement.glsl"

layout(location = 0) out vec4 out_line;

vec4 laid_over(vec4 below, vec4 line, float agreement, float width, ToneLineStyle style) {
    float opacity = line.w * agreement * across_width(length(line.xy), width, style.highlight_color.w);
    vec3 color = line.z > 0.0 ? style.color.rgb : style.highlight_color.rgb;
    return vec4(color * opacity, opacity) + below * (1.0 - opacity);
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec4 diffuse = vec4(0.0), specular = vec4(0.0);
#if CHANNELS != 2
    diffuse = texelFetch(found_lines, pixel, 0);
#endif
#if CHANNELS != 1
    specular = texelFetch(specular_found_lines, pixel, 0);
#endif
    if (max(diffuse.w, specular.w) <= 0.0) discard;
#ifdef UNIFORM_STYLE
    ToneLineStyle style = only_style;
#else
    ToneLineStyle style = styles[owner_of(pixel)];
#endif
    if (style.line.y <= 0.0) discard;
#ifdef STACK
    vec2 seen = texelFetch(widths, pixel, 0).ba;
    float width = widest_line * seen.x / seen.y;
#else
    float width = style.line.x;
#endif
    out_line = vec4(0.0);
#if CHANNELS != 2
    out_line = laid_over(out_line, diffuse, agreement(found_lines, diffuse), width, style);
#endif
#if CHANNELS != 1
    out_line = laid_over(out_line, specular, agreement(specular_found_lines, specular), width, style);
#endif
}
