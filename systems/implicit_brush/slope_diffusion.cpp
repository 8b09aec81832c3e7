#include <hachure/runtime/assert.h>
#include <hachure/systems/implicit_brush/field_pass.h>
#include <hachure/systems/implicit_brush/slope_diffusion.h>

#include <algorithm>
#include <array>
#include <span>
#include <string>

namespace hachure {
namespace {

constexpr std::array axes{glm::ivec2(1, 0), glm::ivec2(0, 1)};

} // namespace

void SlopeDiffusionJob::run(RenderContext& render) const {
    HACHURE_ASSERT(steps >= 1 && steps_at_once >= 1, "diffusion has steps");
    const int rounds = (steps + steps_at_once - 1) / steps_at_once;
    for (int round = 0; round < rounds; ++round) {
        // As even as can be: 11 steps are 4, 4 and 3.
        const int at_once = steps * (round + 1) / rounds - steps * round / rounds;
        gpu::ProgramSource source = field_program("implicit_brush/diffuse.frag");
        source.defines = {{"STEPS", std::to_string(at_once)}};
        gpu::Program& program = render.shaders->program(source);
        const std::array targets{scratch, to};
        for (std::size_t i = 0; i < axes.size(); ++i) {
            program.set("axis", axes[i]);
            draw_field(render, program, {rect, depth_buffer}, targets[i], {i == 1 ? scratch : round == 0 ? from : to});
        }
    }
}

void WidenJob::run(RenderContext& render) const {
    HACHURE_ASSERT(reach >= 1 && reach <= 16, "a binomial that floats hold");
    std::array<float, 17> weights{1.0f}; // of the binomial with 2 * reach factors, from the middle outwards
    for (int i = 1; i <= reach; ++i) weights[0] *= static_cast<float>(reach + i) / static_cast<float>(4 * i);
    for (int i = 1; i <= reach; ++i)
        weights[static_cast<std::size_t>(i)] = weights[static_cast<std::size_t>(i - 1)] *
                                               static_cast<float>(reach - i + 1) / static_cast<float>(reach + i);
    gpu::ProgramSource source = field_program("implicit_brush/widen.frag");
    source.defines = {{"REACH", std::to_string(reach)}};
    gpu::Program& program = render.shaders->program(source);
    program.set("weights", std::span<const float>(weights).first(static_cast<std::size_t>(reach) + 1));
    const std::array targets{scratch, to};
    for (std::size_t i = 0; i < axes.size(); ++i) {
        program.set("axis", axes[i]);
        draw_field(render, program, {rect}, targets[i], {i == 0 ? from : scratch});
    }
}

} // namespace hachure
