// The line beside the edge of a tone, where there is no ridge to arrive at: by the profile of the tone across it, sampled
// once, half a spacing apart. All that the search asks there is read from that.

// Curvature and slope (in tone over half widths, > 0 as the line's own) at nodes half a spacing apart, from one spacing
// before the pixel to two and a half beyond it; beyond is away from the edge.
struct Profile {
    vec4 curvature[2];
    vec4 slope[2];
};
const float pixel_node = 2.0; // the node that is the pixel

Profile profile_across(float side, float spacing, vec2 away) {
    float t[12];
    for (int i = 0; i < 12; ++i) t[i] = side * tone_at(0.5 * spacing * (float(i) - 4.0) * away);
    Profile profile;
    for (int i = 0; i < 8; ++i) {
        profile.curvature[i / 4][i % 4] = 0.5 * (t[i] + t[i + 4]) - t[i + 2];
        profile.slope[i / 4][i % 4] = 0.5 * (t[i + 4] - t[i]);
    }
    return profile;
}

// Between nodes, in a straight line.
float at_node(vec4 values[2], float node) {
    vec4 low = max(1.0 - abs(node - vec4(0.0, 1.0, 2.0, 3.0)), 0.0);
    vec4 high = max(1.0 - abs(node - vec4(4.0, 5.0, 6.0, 7.0)), 0.0);
    return dot(values[0], low) + dot(values[1], high);
}

// Where the curvature is largest, within a spacing of the pixel: a deviation of the blur from the edge.
float most_curved_node(Profile profile) {
    float c[8] = float[8](profile.curvature[0].x, profile.curvature[0].y, profile.curvature[0].z, profile.curvature[0].w,
                          profile.curvature[1].x, profile.curvature[1].y, profile.curvature[1].z, profile.curvature[1].w);
    float largest = -1.0, node = pixel_node;
    for (int i = 1; i < 5; ++i) {
        float bend = 2.0 * c[i] - c[i - 1] - c[i + 1];
        bool is_larger = c[i] > largest;
        largest = is_larger ? c[i] : largest;
        float between = bend > 0.0 ? 0.5 * (c[i + 1] - c[i - 1]) / bend : c[i + 1] > c[i - 1] ? 0.5 : -0.5;
        node = is_larger ? float(i) + clamp(between, -0.5, 0.5) : node;
    }
    return node;
}

// The paper's search (section 3.2): steps of a part beta of the distance to the ridge that the fit shows. Near a ridge
// they end at it; from an edge they lead away, and the curvature that is left tells strong edges from weak ones.
// Returns it, or 0 where the way, added up, is longer than half the line's width; without a jump.
float curvature_after_walk(Profile profile, float node, float beta) {
    float way = 0.0, curvature = at_node(profile.curvature, node); // half widths
    for (int i = 1; i < ITERATIONS; ++i) {
        float distance = -0.5 * at_node(profile.slope, node) / max(curvature, 1e-6);
        float step = beta * clamp(distance, -2.0, 2.0);
        way += abs(step);
        node += 2.0 * step;
        curvature = at_node(profile.curvature, node);
    }
    return max(curvature, 0.0) * (1.0 - smoothstep(1.0, 1.25, way));
}

struct Beside {
    vec2 offset;     // px, from the pixel's middle to the line's
    float curvature; // that is left of the edge's
};

// The line's middle is half a spacing beyond where the curvature is largest. All pixels across a line come to the same
// place, which keeps its outline smooth, and none of them lies where the curvature turns over.
Beside find_beside_edge(float spacing, float side, float beta, Principal start) {
    vec2 away = start.distance < 0.0 ? -start.across : start.across;
    Profile profile = profile_across(side, spacing, away);
    float node = most_curved_node(profile);
    float curvature = max(at_node(profile.curvature, node), 1e-6);
    float distance = -0.5 * at_node(profile.slope, node) / curvature;
    node += clamp(2.0 * distance, -1.0, 1.0);
    return Beside(0.5 * spacing * (node - pixel_node) * away, curvature_after_walk(profile, node, beta));
}
