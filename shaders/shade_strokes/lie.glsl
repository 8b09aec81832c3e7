// How a surface lies on the screen at a node, and what follows from it: how many strokes there are, and how wide.
#include "common/view.glsl"
#include "shade_strokes/ink.glsl"
#include "shade_strokes/patch.glsl"

uniform float unit;       // of zigzags, in the mesh's units
uniform float line_width; // pixels, that strokes are to have where there is little shade

const float MOST_WIDTH = 4.0;                      // times line_width
const float LOG_VALUES[2] = float[2](-0.999, 6.0); // all points of the table are used, or every 64th

vec3 middle(uint n) { return ribs.at[n * RIB_POINTS + 2].xyz; }

// False where it is not before the eye.
bool project(vec3 world, out vec2 pixel) {
    vec4 clip = clip_from_world * vec4(world, 1.0);
    pixel = (clip.xy / clip.w * 0.5 + 0.5) * viewport;
    return clip.w > 1e-6 && clip.z <= clip.w;
}

struct Lie {
    vec2 along;  // pixels of one unit of a zigzag
    vec2 across; // pixels from the middle to the left
    float log_value;
};

// Pixels of one unit of a zigzag, from one node to another.
bool along_of(uint from_node, uint to_node, float length_, out vec2 along) {
    vec2 from, to;
    bool ok = project(middle(from_node), from);
    ok = project(middle(to_node), to) && ok;
    along = (to - from) * (unit / length_);
    return ok;
}

bool lie_at(uint left_node, uint node, uint right_node, float length_, out Lie lie) {
    vec2 right, left;
    bool ok = along_of(left_node, right_node, length_, lie.along);
    ok = project(ribs.at[node * RIB_POINTS].xyz, right) && ok;
    ok = project(ribs.at[node * RIB_POINTS + 4u].xyz, left) && ok;
    lie.across = 0.5 * (left - right);
    return ok;
}

float cross2(vec2 a, vec2 b) { return a.x * b.y - a.y * b.x; }

// The level of detail's value for which strokes are so far apart, across themselves, that lines of `line_width` have
// the ink that little shade needs. At a value of 1 points of the zigzag that count are 2 units apart.
float log_value(Lie lie) {
    float reach = length(lie.across);
    float apart = reach > 1e-4 ? abs(cross2(lie.across, lie.along)) / reach : length(lie.along);
    float wanted = line_width / (3.0 * density * darkness);
    return clamp(log2(wanted / max(2.0 * apart, 1e-6)), LOG_VALUES[0], LOG_VALUES[1]);
}

// For which strokes have the ink per area that the cell's shade needs: area of the zigzag over length of its lines.
float half_width(Lie lie, float shade) {
    float t;
    float apart = exp2(float(level_of(lie.log_value, t)));
    float area = 2.0 * abs(cross2(lie.across, lie.along)) * apart;
    float line = mean_stroke(length(lie.across), length(lie.along) * apart, t);
    return 0.5 * min(density * ink_of_shade(shade) * area / max(line, 1e-6), MOST_WIDTH * line_width);
}
