#include <hachure/runtime/assert.h>
#include <hachure/systems/implicit_brush/field_pass.h>
#include <hachure/systems/implicit_brush/widen_job.h>

#include <array>
#include <cstddef>
#include <span>
#include <string>

namespace hachure {

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
    const std::array along{glm::ivec2(1, 0), glm::ivec2(0, 1)};
    for (std::size_t i = 0; i < along.size(); ++i) {
        program.set("axis", along[i]);
        draw_field(render, program, {rect}, targets[i], {i == 0 ? from : scratch});
    }
}

} // namespace hachure
