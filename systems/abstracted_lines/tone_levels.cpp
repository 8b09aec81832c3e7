#include <hachure/systems/abstracted_lines/tone_levels.h>

#include <algorithm>
#include <cmath>

namespace hachure {

std::vector<double> stack_widths(double narrowest, double widest) {
    if (widest <= narrowest * (1.0 + 1e-6)) return {widest};
    const double octaves = std::log2(widest / narrowest);
    const auto steps = static_cast<std::size_t>(std::max(1.0, std::ceil(2.0 * octaves - 1e-9)));
    std::vector<double> widths;
    for (std::size_t i = 0; i <= steps; ++i)
        widths.push_back(narrowest * std::exp2(octaves * static_cast<double>(i) / static_cast<double>(steps)));
    return widths;
}

std::vector<double> stack_steps(const std::vector<double>& widths) {
    std::vector<double> steps;
    double before = 0.0;
    for (const double width : widths) {
        const double sigma = blur_sigma(width);
        steps.push_back(std::sqrt(sigma * sigma - before * before));
        before = sigma;
    }
    return steps;
}

int blur_radius(double sigma) { return std::max(1, static_cast<int>(std::ceil(2.75 * sigma))); }

std::vector<float> blur_weights(double sigma) {
    const int radius = blur_radius(sigma);
    std::vector<double> weights;
    double sum = 0.0;
    for (int i = 0; i <= radius; ++i) {
        weights.push_back(std::exp(-0.5 * i * i / (sigma * sigma)));
        sum += i == 0 ? weights.back() : 2.0 * weights.back();
    }
    std::vector<float> result;
    for (const double weight : weights) result.push_back(static_cast<float>(weight / sum));
    return result;
}

} // namespace hachure
