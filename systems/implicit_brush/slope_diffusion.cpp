#include <hachure/runtime/assert.h>
#include <hachure/systems/implicit_brush/field_pass.h>
#include <hachure/systems/implicit_brush/slope_diffusion.h>

#include <array>
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
            draw_field(render, program, {rect, depth_buffer, round == 0}, targets[i],
                       {i == 1       ? scratch
                        : round == 0 ? from
                                     : to});
        }
    }
}

} // namespace hachure
