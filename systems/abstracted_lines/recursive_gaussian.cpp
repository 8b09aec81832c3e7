#include <hachure/runtime/assert.h>
#include <hachure/systems/abstracted_lines/recursive_gaussian.h>

#include <glm/geometric.hpp>

#include <cmath>
#include <complex>
#include <vector>

namespace hachure {
namespace {

using Complex = std::complex<double>;

// Poles for deviation 2 (table 1 of the paper, least greatest error): one pair and one real; other deviations take them
// to the power 1 / q.
const Complex pair_pole(1.41650, 1.00829);
constexpr double real_pole = 1.86543;

Complex scaled(Complex pole, double q) { return std::polar(std::pow(std::abs(pole), 1.0 / q), std::arg(pole) / q); }

double variance(double q) {
    const auto part = [](Complex pole) { return 2.0 * pole / ((pole - 1.0) * (pole - 1.0)); };
    return 2.0 * part(scaled(pair_pole, q)).real() + part(scaled(real_pole, q)).real();
}

/// The q whose filter has this variance, which grows with q.
double scale_for(double wanted) {
    double low = 1e-3, high = std::sqrt(wanted) + 1.0;
    for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (low + high);
        (variance(middle) < wanted ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

/// The filter's state: how far the result is from x, and the last two differences.
using State = glm::dvec3;

State advanced(const RecursiveGaussian& filter, double sample, const State& state) {
    const double d = filter.gain * (sample - state.x) + glm::dot(filter.keep, glm::dvec2(state.y, state.z));
    return {state.x + d, d, state.y};
}

/// What comes back of a state at the end: the way there goes on until nothing is left of it.
State tail_of(const RecursiveGaussian& filter, State state, int beyond) {
    std::vector<double> there;
    for (int n = 0; n < beyond; ++n) {
        state = advanced(filter, 0.0, state);
        there.push_back(state.x);
    }
    State back(0.0);
    for (std::size_t n = there.size(); n-- > 0;) back = advanced(filter, there[n], back);
    return back;
}

} // namespace

RecursiveGaussian recursive_gaussian(double deviation) {
    HACHURE_ASSERT(deviation >= 0.5, "a deviation that samples can show");
    const double q = scale_for(deviation * deviation);
    const Complex a = 1.0 / scaled(pair_pole, q);
    const double c = 1.0 / scaled(real_pole, q).real(), square = std::norm(a);
    RecursiveGaussian filter;
    filter.keep = {square + 2.0 * a.real() * c - square * c, -square * c};
    filter.gain = std::norm(1.0 - a) * (1.0 - c);
    const int beyond = static_cast<int>(20.0 * deviation) + 40;
    for (int i = 0; i < 3; ++i) {
        State unit(0.0);
        unit[i] = 1.0;
        filter.tail[i] = tail_of(filter, unit, beyond);
    }
    return filter;
}

} // namespace hachure
