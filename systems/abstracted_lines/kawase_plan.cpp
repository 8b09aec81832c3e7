#include <hachure/systems/abstracted_lines/kawase_plan.h>

#include <array>
#include <cmath>

namespace hachure {
namespace {

constexpr int most_levels = 8;
constexpr double least_offset = 0.5, most_offset = 2.0;

/// What a bilinear sample between texels adds, square texels.
double bilinear(double place) {
    const double t = place - std::floor(place);
    return t * (1.0 - t);
}

/// Of kawase_down.frag: half the weight in the middle of four texels, half at the corners of a square around it.
double down(double o) { return 0.5 * 0.25 + 0.5 * (o * o + bilinear(0.5 + o)); }

/// Of kawase_up.frag, in texels of what is doubled: pixels lie at a quarter and at three quarters of its texels.
double up(double o) {
    double sum = 0.0;
    for (const double phase : {0.25, 0.75}) {
        const double axis = 2.0 * (o * o + bilinear(phase + o)) + 2.0 * bilinear(phase);
        const double corners = 8.0 * (0.25 * o * o + bilinear(phase + 0.5 * o));
        sum += (axis + corners) / 12.0;
    }
    return 0.5 * sum;
}

double variance(int levels, double offset) {
    double sum = 0.0, texel = 1.0; // square pixels of a texel's side
    for (int level = 0; level < levels; ++level, texel *= 4.0) sum += texel * (down(offset) + 4.0 * up(offset));
    return sum;
}

/// Between offsets whose variances are about the wanted one: it grows with the offset but for ripples, so the first
/// crossing from below.
double offset_for(int levels, double wanted) {
    constexpr int steps = 600;
    const auto at = [](int i) { return least_offset + (most_offset - least_offset) * i / steps; };
    if (variance(levels, least_offset) >= wanted) return least_offset;
    for (int i = 1; i <= steps; ++i)
        if (variance(levels, at(i)) >= wanted) return at(i);
    return most_offset;
}

} // namespace

KawasePlan kawase_plan(double deviation) {
    const double wanted = deviation * deviation;
    KawasePlan best;
    double best_badness = 1e9;
    for (int levels = 1; levels <= most_levels; ++levels) {
        const double offset = offset_for(levels, wanted), reached = variance(levels, offset);
        const double badness = 10.0 * std::abs(std::log(reached / wanted)) + std::abs(std::log(offset));
        if (badness >= best_badness) continue;
        best_badness = badness;
        best = {levels, offset, reached};
    }
    return best;
}

} // namespace hachure
