#include <hachure/runtime/gpu/gl.h>
#include <hachure/systems/abstracted_lines/recursive_gaussian.h>
#include <hachure/systems/abstracted_lines/tone_blur_kinds.h>

#include <cmath>
#include <string>

namespace hachure {
namespace {

/// What GLSL calls the format of an image.
std::string image_format(gpu::Format format) {
    switch (format) {
    case gpu::Format::rg8:
        return "rg8";
    case gpu::Format::rg16:
        return "rg16";
    case gpu::Format::rg16f:
        return "rg16f";
    case gpu::Format::rg32f:
        return "rg32f";
    case gpu::Format::rgba16:
        return "rgba16";
    case gpu::Format::rgba16f:
        return "rgba16f";
    default:
        return "rgba32f";
    }
}

bool two_channels(gpu::Format format) {
    return format == gpu::Format::rg8 || format == gpu::Format::rg16 || format == gpu::Format::rg16f ||
           format == gpu::Format::rg32f;
}

/// All rows or all columns of `rect`, there and back.
struct LineSweep {
    std::uint32_t from = 0, there = 0, to = 0;
    gpu::Rect rect;
    bool rows = true;

    void run(RenderContext& render, const RecursiveGaussian& filter) const {
        constexpr int group = 32; // as the shader's local size
        const auto texture = [&](std::uint32_t id) -> const gpu::Texture& { return render.backend->texture(id); };
        gpu::Program& program =
            render.shaders->program({.compute = "abstracted_lines/blur_recursive.comp",
                                     .defines = {{"THERE_FORMAT", image_format(texture(there).desc().format)},
                                                 {"RESULT_FORMAT", image_format(texture(to).desc().format)},
                                                 {"CHANNELS", std::to_string(texture(to).channels())}}});
        const int lines = rows ? rect.height : rect.width;
        program.set("first", glm::ivec2(rect.x, rect.y));
        program.set("along", rows ? glm::ivec2(1, 0) : glm::ivec2(0, 1));
        program.set("lines", lines);
        program.set("texels", rows ? rect.width : rect.height);
        program.set("gain", static_cast<float>(filter.gain));
        program.set("keep", glm::vec2(filter.keep));
        program.set("tail", glm::mat3(filter.tail));
        program.use();
        texture(from).bind(0);
        texture(there).bind_image(0, GL_READ_WRITE);
        texture(to).bind_image(1, GL_WRITE_ONLY);
        gpu::gl().DispatchCompute(static_cast<GLuint>((lines + group - 1) / group), 1, 1);
        gpu::gl().MemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT |
                                GL_TEXTURE_UPDATE_BARRIER_BIT | GL_FRAMEBUFFER_BARRIER_BIT);
    }
};

} // namespace

std::vector<gpu::TextureDesc> recursive_scratch(const gpu::TextureDesc& desc) {
    const gpu::Format format = two_channels(desc.format) ? gpu::Format::rg32f : gpu::Format::rgba32f;
    return {{desc.width, desc.height, format}, {desc.width, desc.height, format}};
}

void blur_recursive(RenderContext& render, const ToneBlurJob& job, std::span<const std::uint32_t> scratch) {
    // What the filter takes for a line's end has to be far enough away.
    const int margin = static_cast<int>(std::ceil(3.0 * job.sigma));
    const gpu::Rect rect = grown(job.rect, margin, margin, job.valid);
    const RecursiveGaussian filter = recursive_gaussian(job.sigma);
    LineSweep{job.from, scratch[0], scratch[1], rect, true}.run(render, filter);
    LineSweep{scratch[1], scratch[0], job.to, rect, false}.run(render, filter);
}

} // namespace hachure
