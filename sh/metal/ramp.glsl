// The stripes of a set and the stripe of the light, averaged over a pixel in closed form.
//
// The stripes are a periodic function c(x) that is linear between whole numbers, the centres of the stripes
// (systems/metal/stripe_ramp.h). Within a pixel x is as good as linear in both directions of the screen: it changes by
// `a` across the pixel and by `b` down, so that it is distributed as the sum of two evenly spread numbers of those
// widths, a trapezoid. The average of c over the pixel is the average over that trapezoid, which has a closed form.

const int MAX_KNOTS = 512;

layout(std140, binding = 2) uniform Ramp {
    vec4 knots[MAX_KNOTS]; // by stripe: c - mean, slope to the next, first and second antiderivative of c - mean
};
uniform int knot_count;
uniform float ramp_mean;

// How x is distributed over the pixel: a trapezoid around its middle, `high + low` wide below, `high - low` above.
struct Footprint {
    float low, high; // the smaller and the larger of the widths a and b
};

Footprint footprint_of(float a, float b, float largest) {
    return Footprint(clamp(min(a, b), 1e-7, largest), clamp(max(a, b), 1e-7, largest));
}

// A place among the stripes, in two parts so that far from 0 no digits are lost.
struct Place {
    float stripe; // whole: the centre before it, in the first period
    float within; // [0, 1)
};

Place place_of(float x) {
    float stripe = floor(x), within = x - stripe, count = float(knot_count);
    return Place(stripe - count * floor(stripe / count), within);
}

// Of a stripe within a period of the first one's.
vec4 near_knot(float stripe) {
    int i = int(stripe);
    i += i < 0 ? knot_count : i >= knot_count ? -knot_count : 0;
    return knots[clamp(i, 0, knot_count - 1)];
}

vec4 knot(float stripe) {
    float count = float(knot_count);
    return near_knot(stripe - count * floor(stripe / count));
}

// Average of max(0, X - d), where X is distributed as the footprint around 0.
float beyond(Footprint f, float d) {
    vec2 ends = max(0.5 * vec2(f.high + f.low, f.high - f.low) - abs(d), 0.0);
    // The difference of two cubes over 6 low high; their own difference is `low` where both are there.
    float share = ends.y > 0.0 ? 1.0 : min(ends.x / f.low, 1.0);
    return share * (ends.x * (ends.x + ends.y) + ends.y * ends.y) / (6.0 * f.high) + max(-d, 0.0);
}

// The second antiderivative of c - mean, `by` stripes from the centre before the place.
float second_antiderivative(Place at, float by) {
    float whole = floor(by), t = by - whole;
    vec4 k = knot(at.stripe + whole);
    return k.w + t * (k.z + t * (0.5 * k.x + t * k.y / 6.0));
}

// Average of c - mean over the footprint around the place.
float filtered_ramp(Footprint f, Place at) {
    if (f.low + f.high <= 2.0) {
        // At most the two ends of the piece lie within: the piece, and what the stripes bend away from it at each end.
        vec4 piece = near_knot(at.stripe);
        float before = near_knot(at.stripe - 1.0).y, after = near_knot(at.stripe + 1.0).y;
        return piece.x + piece.y * at.within + (piece.y - before) * beyond(f, at.within) +
               (after - piece.y) * beyond(f, 1.0 - at.within);
    }
    // The average over `high` of the average over `low`, by differences of antiderivatives. Where `low` is small, its
    // box is widened to .05 stripes rather than let the difference lose its digits: that moves the result by 1e-4.
    float low = max(f.low, 0.05);
    float outer = 0.5 * (f.high + low), inner = 0.5 * (f.high - low), t = at.within;
    float right = second_antiderivative(at, t + outer) - second_antiderivative(at, t + inner);
    float left = second_antiderivative(at, t - inner) - second_antiderivative(at, t - outer);
    return (right - left) / (f.high * low);
}

// Whether the light's stripe lies so near that the footprint may hold some of its white.
bool light_is_near(Footprint f, float towards_light) { return abs(towards_light) < 0.5 * (f.low + f.high) + 2.5; }

// The stripe that faces the light lies `towards_light` stripes from the place, as a rule between two centres. The one
// whose centre is nearest is white; its neighbours are mixed with white by how near the light is to them, so that white
// moves on to the next without a jump. x: average over the footprint of how white the surface is; y: the average of what
// c has there, so that white replaces it.
vec2 filtered_light(Footprint f, Place at, float towards_light) {
    float light = at.within + towards_light, nearest = round(light);
    float off = light - nearest, d = at.within - nearest;
    // The average of a hat around 0 is the second difference of `beyond`.
    float steps[5] = float[5](beyond(f, d + 2.0), beyond(f, d + 1.0), beyond(f, d), beyond(f, d - 1.0),
                              beyond(f, d - 2.0));
    vec3 hats = vec3(steps[0] - 2.0 * steps[1] + steps[2], steps[1] - 2.0 * steps[2] + steps[3],
                     steps[2] - 2.0 * steps[3] + steps[4]);
    vec3 white = hats * vec3(0.5 - off, 1.0, 0.5 + off);
    float centre = at.stripe + nearest;
    vec3 covered = vec3(knot(centre - 1.0).x, knot(centre).x, knot(centre + 1.0).x) + ramp_mean;
    return vec2(white.x + white.y + white.z, dot(white, covered));
}
