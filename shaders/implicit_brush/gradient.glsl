// The gradient of a field by a linear fit to the 3x3 pixels around, of those that count: differences to neighbours that
// an insulator cuts off are no differences of the surface, and the fit goes by the others. Beside an edge of the
// picture or of a surface it is one-sided by itself.
//
// Weights 4 along the axes and 1 along the diagonals make it alike in all directions: with all neighbours it is the
// derivative of the field smoothed by a variance of 1/3 px^2 along either axis.

struct Normal { // normal equations of the fit
    float xx, xy, yy;
};

const ivec2 around[8] = ivec2[8](ivec2(1, 0), ivec2(-1, 0), ivec2(0, 1), ivec2(0, -1), ivec2(1, 1), ivec2(-1, 1),
                                 ivec2(1, -1), ivec2(-1, -1));

float around_weight(int i) { return i < 4 ? 4.0 : 1.0; }

void add(inout Normal m, vec2 d, float weight) {
    m.xx += weight * d.x * d.x;
    m.xy += weight * d.x * d.y;
    m.yy += weight * d.y * d.y;
}

// `sum`: of weight * difference * d. Where neighbours leave a direction open there is no slope along it.
vec2 gradient(Normal m, vec2 sum) {
    m.xx += 1e-3, m.yy += 1e-3;
    return vec2(m.yy * sum.x - m.xy * sum.y, m.xx * sum.y - m.xy * sum.x) / (m.xx * m.yy - m.xy * m.xy);
}
