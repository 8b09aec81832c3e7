#include <hachure/systems/abstracted_lines/recursive_gaussian.h>

#include <glm/vec3.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace hachure {
namespace {

/// The filter as shaders/abstracted_lines/blur_recursive.comp runs it: beyond the ends everything is as at the ends.
std::vector<double> filtered(std::vector<double> x, const RecursiveGaussian& filter) {
    glm::dvec3 state(x.front(), 0.0, 0.0);
    const glm::dvec3 end(x.back(), 0.0, 0.0);
    const auto advance = [&](double& v) {
        const double d = filter.gain * (v - state.x) + filter.keep.x * state.y + filter.keep.y * state.z;
        state = {state.x + d, d, state.y};
        v = state.x;
    };
    for (double& v : x) advance(v);
    state = end + filter.tail * (state - end);
    for (std::size_t i = x.size(); i-- > 0;) advance(x[i]);
    return x;
}

class RecursiveGaussianOf : public ::testing::TestWithParam<double> {};

TEST_P(RecursiveGaussianOf, HasSumOneAndTheVariance) {
    const double s = GetParam();
    const int middle = static_cast<int>(20.0 * s) + 10;
    std::vector<double> impulse(static_cast<std::size_t>(2 * middle + 1));
    impulse[static_cast<std::size_t>(middle)] = 1.0;
    const std::vector<double> response = filtered(impulse, recursive_gaussian(s));
    double sum = 0.0, mean = 0.0, square = 0.0;
    for (std::size_t i = 0; i < response.size(); ++i) {
        const double u = static_cast<double>(i) - middle;
        sum += response[i], mean += u * response[i], square += u * u * response[i];
    }
    EXPECT_NEAR(sum, 1.0, 1e-9);
    EXPECT_NEAR(mean, 0.0, 1e-9);
    EXPECT_NEAR(square / (s * s), 1.0, 1e-6);
}

TEST_P(RecursiveGaussianOf, IsNearTheGaussian) {
    const double s = GetParam();
    const int middle = static_cast<int>(6.0 * s) + 4;
    std::vector<double> impulse(static_cast<std::size_t>(2 * middle + 1));
    impulse[static_cast<std::size_t>(middle)] = 1.0;
    const std::vector<double> response = filtered(impulse, recursive_gaussian(s));
    const double peak = 1.0 / (s * std::sqrt(2.0 * std::numbers::pi));
    for (std::size_t i = 0; i < response.size(); ++i) {
        const double u = (static_cast<double>(i) - middle) / s;
        EXPECT_NEAR(response[i] / peak, std::exp(-0.5 * u * u), s < 1.5 ? 0.04 : 0.03) << s << " " << u;
    }
}

/// A step near the end comes out as one far from it whose upper side never ends.
TEST_P(RecursiveGaussianOf, EndsAsIfTheLastValueWentOn) {
    const double s = GetParam();
    const RecursiveGaussian filter = recursive_gaussian(s);
    const auto size = static_cast<std::size_t>(12.0 * s) + 20;
    std::vector<double> cut(size, 0.0), whole(3 * size, 0.0);
    for (std::size_t i = 0; i < whole.size(); ++i) {
        const double v = i + 4 < size ? 0.0 : 1.0 + 0.1 * static_cast<double>(std::min(i, size - 1) % 3);
        whole[i] = v;
        if (i < size) cut[i] = v;
    }
    const std::vector<double> a = filtered(cut, filter), b = filtered(whole, filter);
    for (std::size_t i = 0; i < size; ++i) EXPECT_NEAR(a[i], b[i], 1e-9) << i;
}

INSTANTIATE_TEST_SUITE_P(Deviations, RecursiveGaussianOf, ::testing::Values(1.0, 1.5, 2.0, 4.0, 12.0, 32.0));

} // namespace
} // namespace hachure
