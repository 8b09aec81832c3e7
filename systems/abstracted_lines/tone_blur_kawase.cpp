#include <hachure/systems/abstracted_lines/kawase_plan.h>
#include <hachure/systems/abstracted_lines/tone_blur_kinds.h>

#include <cmath>

namespace hachure {
namespace {

constexpr const char* down_shader = "abstracted_lines/kawase_down.frag";
constexpr const char* up_shader = "abstracted_lines/kawase_up.frag";

void set_offset(RenderContext& render, const char* fragment, double offset) {
    render.shaders->program({.vertex = "common/full_screen.vert", .fragment = fragment})
        .set("offset", static_cast<float>(offset));
}

} // namespace

bool fits_pyramid(double sigma) { return sigma >= 1.1; }

std::vector<gpu::TextureDesc> kawase_scratch(double sigma, const gpu::TextureDesc& desc) {
    std::vector<gpu::TextureDesc> levels;
    for (int i = kawase_plan(sigma).levels; i > 0; --i) levels.push_back(halved(levels.empty() ? desc : levels.back()));
    return levels;
}

/// Down into each level, then up again over them. Level 0 is the picture.
void blur_kawase(RenderContext& render, const ToneBlurJob& job, std::span<const std::uint32_t> scratch) {
    const KawasePlan plan = kawase_plan(job.sigma);
    const int reach = static_cast<int>(std::ceil(plan.offset)) + 1;
    const std::size_t levels = scratch.size();
    std::vector<gpu::Rect> valid = {job.valid}, up = {job.rect};
    for (std::size_t i = 1; i <= levels; ++i) {
        valid.push_back(halved(valid.back()));
        up.push_back(grown(halved(up.back()), reach, reach, valid.back()));
    }
    std::vector<gpu::Rect> down = up;
    for (std::size_t i = levels; i-- > 1;) down[i] = grown(doubled(down[i + 1]), reach, reach, valid[i]);
    set_offset(render, down_shader, plan.offset);
    for (std::size_t i = 1; i <= levels; ++i)
        BlurDraw{i == 1 ? job.from : scratch[i - 2], scratch[i - 1], i == 1 ? job.valid : down[i - 1], down[i]}.sampled(
            render, down_shader);
    set_offset(render, up_shader, plan.offset);
    for (std::size_t i = levels; i-- > 0;)
        BlurDraw{scratch[i], i == 0 ? job.to : scratch[i - 1], up[i + 1], up[i]}.sampled(render, up_shader);
}

} // namespace hachure
