#version 450 core
// The picture on paper, with its lines. SHADING: surfaces too, and all of the picture is written; else lines alone are,
// to be blended. LINES: there are some; 0 where they do not show the paper.
#include "paper/transfer.glsl"

#ifdef LINES
layout(binding = 1) uniform sampler2D line_layer; // premultiplied
uniform ivec4 line_rect;                          // holds lines: left, bottom, right, top
#endif
#ifdef SHADING
layout(binding = 2) uniform sampler2D color;
uniform vec3 bare; // the paper's colour
uniform vec3 bare_from, bare_to; // what rounding makes of it
#endif

layout(location = 0) out vec4 out_color;

#ifdef LINES
vec4 line_on_paper() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    if (any(lessThan(pixel, line_rect.xy)) || any(greaterThanEqual(pixel, line_rect.zw))) return vec4(0.0);
    vec4 line = texelFetch(line_layer, pixel, 0);
#if LINES
    if (line.a > 0.0) line *= caught(line.a) / line.a;
#endif
    return line;
}
#endif

#ifdef SHADING
// A colour is paper that is covered in part by the strongest pigment of its hue: where the line from the paper's colour
// through it leaves the cube of colours. What is within rounding of the paper is paper, or it would be speckled.
vec3 shading_on_paper(vec3 shaded) {
    vec3 away = shaded - bare;
    if (all(greaterThan(shaded, bare_from)) && all(lessThan(shaded, bare_to))) return shaded;
    vec3 room = mix(bare, 1.0 - bare, greaterThan(away, vec3(0.0)));
    vec3 parts = abs(away) / max(room, 1e-4);
    float amount = max(parts.r, max(parts.g, parts.b));
    return bare + away * (caught(amount) / amount);
}
#endif

void main() {
#ifdef LINES
    vec4 line = line_on_paper();
#else
    vec4 line = vec4(0.0);
#endif
#ifdef SHADING
    vec3 shaded = shading_on_paper(texelFetch(color, ivec2(gl_FragCoord.xy), 0).rgb);
    out_color = vec4(shaded * (1.0 - line.a) + line.rgb, 1.0);
#else
    out_color = line;
#endif
}
