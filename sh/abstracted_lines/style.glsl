// The look of lines, by object id; systems/abstracted_lines/tone_line_style.h is the same.
struct ToneLineStyle {
    vec4 color;           // of dark lines; w: beta
    vec4 highlight_color; // w: fade
    vec4 thresholds;      // c_l and c_u of dark lines, then of highlight lines
    vec4 kinds;           // 1 where dark, highlight, specular, specular dark lines are wanted
    vec4 line;            // width px; 1 where pixels draw; counterchange; 1 where there are lines at all
};

#ifdef UNIFORM_STYLE
layout(std140, binding = 2) uniform Style { ToneLineStyle only_style; };
#else
layout(std430, binding = 0) readonly buffer Styles { ToneLineStyle styles[]; };
layout(binding = 2) uniform usampler2D object_ids;
uniform ivec4 object_area; // first and last pixel of the view
uniform float owner_reach; // px: how far from what has them lines can be

bool has_lines(uint object) { return object < uint(styles.length()) && styles[object].line.w > 0.0; }

uint object_at(ivec2 pixel) { return texelFetch(object_ids, clamp(pixel, object_area.xy, object_area.zw), 0).r; }

// Whose parameters hold at a pixel: those of what is seen there; on the background, of the nearest that is seen beside
// it, since half of a line along an outline lies there. 0: none.
uint owner_of(ivec2 pixel) {
    uint object = object_at(pixel);
    if (object != 0u) return has_lines(object) ? object : 0u;
    for (float part = 0.25; part <= 1.0; part += 0.25)
        for (int i = 0; i < 8; ++i) {
            float angle = 0.785398 * float(i);
            object = object_at(pixel + ivec2(round(part * owner_reach * vec2(cos(angle), sin(angle)))));
            if (has_lines(object)) return object;
        }
    return 0u;
}
#endif
