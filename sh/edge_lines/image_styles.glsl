// The look of lines from the picture, by object id; systems/edge_lines/image_lines.h fills it.
struct ImageStyle {
    vec4 line;           // colour, and half width: pixels, or where it is negative metres over a pixel's at depth 1
    vec4 crease;         // colour
    float breaks;        // 1 where steps of depth and boundaries of objects are drawn
    float crease_cosine; // of the angle from which a crease is drawn; -2 for none
    vec2 padding;
};
layout(std430, binding = 0) readonly buffer Styles { ImageStyle styles[]; };

bool has_lines(uint object) { return object < uint(styles.length()) && styles[object].line.w != 0.0; }
