// Draws a rib in to a share of its amplitude, along its own straight lines, so that it stays on the surface.

// An inner point that would come to lie beyond the outer one stays this near to the middle, over the outer one's
// distance: so nothing jumps while the share changes, and no two points fall together.
const float INNERMOST_RIM = 0.98;

vec3 on_rib(const vec4 rib[RIB_POINTS], float side) {
    int k = side < 0.0 ? 0 : RIB_POINTS / 2;
    while (k + 2 < RIB_POINTS && side > rib[k + 1].w) ++k;
    return mix(rib[k].xyz, rib[k + 1].xyz, clamp((side - rib[k].w) / (rib[k + 1].w - rib[k].w), 0.0, 1.0));
}

// rib: places, and in w the side from -1 to 1; share: in (0, 1].
void narrow(inout vec4 rib[RIB_POINTS], float share) {
    const vec4 laid[RIB_POINTS] = rib;
    for (int k = 0; k < RIB_POINTS; ++k) {
        if (k == RIB_POINTS / 2) continue;
        float most = k == 0 || k + 1 == RIB_POINTS ? share : INNERMOST_RIM * share;
        float side = clamp(laid[k].w, -most, most);
        rib[k] = vec4(on_rib(laid, side), side / share);
    }
}
