#include <hachure/systems/abstracted_lines/tone_blur_kinds.h>

#include <cmath>

namespace hachure {
namespace {

constexpr double least_deviation = 1.88; ///< texels

/// What halving adds, `levels` times, and enlarging again: shaders/abstracted_lines/blur_halve.frag and, on average,
/// blur_enlarge.frag. Square pixels.
double own_variance(int levels) {
    const double texel = std::pow(4.0, levels);
    return 0.75 * (texel - 1.0) / 3.0 + texel / 6.0;
}

/// The deviation that is left for the blur of the last level, in its texels.
double left(double sigma, int levels) {
    return std::sqrt(std::max(0.0, sigma * sigma - own_variance(levels)) / std::pow(4.0, levels));
}

} // namespace

int halvings(double sigma) {
    int levels = 0;
    while (left(sigma, levels + 1) >= least_deviation) ++levels;
    return levels;
}

std::vector<gpu::TextureDesc> halved_scratch(double sigma, const gpu::TextureDesc& desc) {
    std::vector<gpu::TextureDesc> levels;
    for (int i = halvings(sigma); i > 0; --i) levels.push_back(halved(levels.empty() ? desc : levels.back()));
    levels.push_back(levels.back());
    return levels;
}

void blur_halved(RenderContext& render, const ToneBlurJob& job, std::span<const std::uint32_t> scratch) {
    const auto levels = static_cast<int>(scratch.size()) - 1;
    const double sigma = left(job.sigma, levels);
    const int reach = static_cast<int>(std::ceil(3.0 * sigma));
    std::vector<gpu::Rect> valid = {job.valid}, drawn(scratch.size());
    gpu::Rect wanted = job.rect;
    for (int i = 0; i < levels; ++i) {
        valid.push_back(halved(valid.back()));
        wanted = halved(wanted);
    }
    wanted = grown(wanted, 1, 1, valid.back());
    // From the last level to the first: what each is made of.
    drawn.back() = grown(wanted, reach, reach, valid.back());
    for (auto i = drawn.size() - 1; i-- > 1;) drawn[i] = grown(doubled(drawn[i + 1]), 1, 1, valid[i]);
    for (std::size_t i = 1; i < drawn.size(); ++i)
        BlurDraw{i == 1 ? job.from : scratch[i - 2], scratch[i - 1], i == 1 ? job.valid : drawn[i - 1], drawn[i]}
            .sampled(render, "abstracted_lines/blur_halve.frag");
    const std::uint32_t last = scratch[scratch.size() - 2];
    blur_separable(render, {.sigma = sigma, .from = last, .to = last, .valid = drawn.back(), .rect = wanted},
                   scratch.back());
    render.shaders->program({.vertex = "common/full_screen.vert", .fragment = "abstracted_lines/blur_enlarge.frag"})
        .set("part", static_cast<float>(std::exp2(-levels)));
    BlurDraw{last, job.to, wanted, job.rect}.sampled(render, "abstracted_lines/blur_enlarge.frag");
}

} // namespace hachure
