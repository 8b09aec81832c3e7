#version 450 core
// Lines along ridges and valleys of the blurred tone image (Lee et al. 2007, section 3). What the pixel finds is kept
// for draw_lines.frag, or with MAPS and POINTS, as far as other pixels agree, becomes numbers for others. Where there is
// no line nothing is written.
layout(binding = 0) uniform sampler2D tones; // red: diffuse, green: specular; blurred by half a line's width
#ifdef STACK
// Widths vary: the next wider blur, and where widths are: blue: width times coverage, alpha: coverage, blurred widely.
#include "abstracted_lines/widest_line.glsl"
layout(binding = 1) uniform sampler2D wider_tones;
layout(binding = 3) uniform sampler2D widths;
uniform vec2 level_widths; // px, that the two images are blurred for
uniform bool first_level, last_level; // of the stack
float wider_part;
#endif

uniform float search_width;    // px, where widths don't vary: what lines are searched for as
uniform float least_curvature; // below it nobody draws a line

ivec2 inside(ivec2 texel) { return clamp(texel, ivec2(0), textureSize(tones, 0) - 1); }

vec2 texel_at(ivec2 texel) { return texelFetch(tones, inside(texel), 0).rg; }

int searched = 0; // the channel

// Of the four texels around a place between them. By whole texels and a fraction that do not depend on where in the
// picture the pixel is: what moves by whole pixels has the same lines, bit for bit, which a filter of the driver does not
// promise. One gather costs what the filter does; four fetches cost half as much again.
float between(sampler2D image, vec2 corner, vec2 part) {
    vec4 four = searched == 0 ? textureGather(image, corner, 0) : textureGather(image, corner, 1);
    vec2 rows = mix(four.wx, four.zy, part.x);
    return mix(rows.x, rows.y, part.y);
}

// The searched channel's tone at an offset from the pixel's middle, px.
float tone_at(vec2 offset) {
    vec2 whole = floor(offset), part = offset - whole;
    vec2 corner = (floor(gl_FragCoord.xy) + whole + 1.0) / vec2(textureSize(tones, 0));
    float tone = between(tones, corner, part);
#ifdef STACK
    tone = mix(tone, between(wider_tones, corner, part), wider_part);
#endif
    return tone;
}

#include "abstracted_lines/fit.glsl"
#include "abstracted_lines/search.glsl"
#include "abstracted_lines/style.glsl"

#if defined(MAPS) || defined(POINTS)
#include "abstracted_lines/across.glsl"
#include "abstracted_lines/agreement.glsl"
layout(binding = 4) uniform sampler2D found_lines; // what was written without these, of diffuse and specular tone
layout(binding = 5) uniform sampler2D specular_found_lines;
#endif

#if defined(MAPS)
layout(location = 0) out vec2 out_distance;
layout(location = 1) out vec2 out_curvature;
layout(location = 2) out vec2 out_opacity;
#elif defined(POINTS)
layout(location = 0) out vec4 out_points;
layout(location = 1) out vec4 out_directions;
layout(location = 2) out vec4 out_specular_points;
layout(location = 3) out vec4 out_specular_directions;
layout(location = 4) out uint out_owner;
#else
layout(location = 0) out vec4 out_found;
layout(location = 1) out vec4 out_specular_found;
#endif

struct Stroke {
    Ridge ridge;
    float strength; // opacity along the line (section 3.3)
};
Stroke no_stroke() { return Stroke(no_ridge(), 0.0); }

Stroke stroke_of(Fit fit, int channel, float tone, float width, ToneLineStyle style) {
    Stroke stroke = no_stroke();
    searched = channel;
    float curvature = curvature_of(fit);
    bool dark = curvature > 0.0;
    float wanted = channel == 0 ? (dark ? style.kinds.x : style.kinds.y) : (dark ? style.kinds.w : style.kinds.z);
    vec2 limits = dark ? style.thresholds.xy : style.thresholds.zw;
    if (wanted <= 0.0 || abs(curvature) < rim_part * limits.x) return stroke;
    stroke.ridge = follow(fit, width, style.color.w, limits.x);
    if (!stroke.ridge.found) return stroke;
    // Counterchange: dark lines are lighter where the tone is light, highlight lines where it is dark.
    float against = mix(1.0, dark ? 1.0 - tone : tone, style.line.z);
    stroke.strength = clamp((abs(stroke.ridge.curvature) - limits.x) / (limits.y - limits.x), 0.0, 1.0) * against;
    return stroke;
}

vec4 as_found(Stroke stroke) { return vec4(stroke.ridge.offset, stroke.ridge.curvature, stroke.strength); }

#if defined(MAPS)
void write_strokes(Stroke diffuse, Stroke specular, float width, uint owner, vec2 tone, ToneLineStyle style) {
    Ridge a = diffuse.ridge, b = specular.ridge;
    out_distance = vec2(a.found ? length(a.offset) : 1e10, b.found ? length(b.offset) : 1e10);
    out_curvature = vec2(a.found ? a.curvature : 0.0, b.found ? b.curvature : 0.0);
    vec2 opacity =
        vec2(diffuse.strength, specular.strength) *
        vec2(agreement(found_lines, as_found(diffuse)), agreement(specular_found_lines, as_found(specular))) *
        vec2(across_width(length(a.offset), width, style.highlight_color.w),
             across_width(length(b.offset), width, style.highlight_color.w));
    float dark = 0.0, light = 0.0;
    if (a.curvature > 0.0) dark = opacity.x; else light = opacity.x;
    if (b.curvature > 0.0) dark = max(dark, opacity.y); else light = max(light, opacity.y);
    out_opacity = vec2(dark, light);
}
#elif defined(POINTS)
void write_strokes(Stroke diffuse, Stroke specular, float width, uint owner, vec2 tone, ToneLineStyle style) {
    Ridge a = diffuse.ridge, b = specular.ridge;
    out_points = vec4(a.offset, a.curvature, diffuse.strength * agreement(found_lines, as_found(diffuse)));
    out_directions = vec4(-a.across.y, a.across.x, width, tone.x);
    out_specular_points =
        vec4(b.offset, b.curvature, specular.strength * agreement(specular_found_lines, as_found(specular)));
    out_specular_directions = vec4(-b.across.y, b.across.x, width, tone.y);
    out_owner = owner;
}
#else
void write_strokes(Stroke diffuse, Stroke specular, float width, uint owner, vec2 tone, ToneLineStyle style) {
    out_found = as_found(diffuse);
    out_specular_found = as_found(specular);
}
#endif

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
#ifdef STACK
    vec2 found = texelFetch(widths, pixel, 0).ba;
    if (found.y < 1e-3) discard;
    float width = widest_line * found.x / found.y;
    if ((width < level_widths.x && !first_level) || (width >= level_widths.y && !last_level)) discard;
    float search = clamp(width, level_widths.x, level_widths.y);
    wider_part = (search * search - level_widths.x * level_widths.x) /
                 (level_widths.y * level_widths.y - level_widths.x * level_widths.x);
#else
    float search = search_width;
#endif
    Fit first, second; // of the diffuse and of the specular tone
#ifdef WHOLE_SPACING
    fit_here(pixel, first, second);
#else
    first = fit_at(vec2(0.0), 0.5 * search);
    searched = 1;
    second = fit_at(vec2(0.0), 0.5 * search);
#endif
    // Before anything is divided: flat tones and ramps end here.
    if (!(max(abs(curvature_of(first)), abs(curvature_of(second))) >= rim_part * least_curvature)) discard;
#ifdef UNIFORM_STYLE
    ToneLineStyle style = only_style;
    uint owner = 1u;
#else
    uint owner = owner_of(pixel);
    if (owner == 0u) discard;
    ToneLineStyle style = styles[owner];
#endif
#ifndef STACK
    float width = style.line.x; // one below the narrowest that is searched for is drawn thinner
#endif
    Stroke diffuse = no_stroke(), specular = no_stroke();
    float tone = clamp(first.tone, 0.0, 1.0);
#if CHANNELS != 2
    diffuse = stroke_of(first, 0, tone, search, style);
#endif
#if CHANNELS != 1
    specular = stroke_of(second, 1, tone, search, style);
#endif
    write_strokes(diffuse, specular, width, owner, vec2(first.tone, second.tone), style);
}
