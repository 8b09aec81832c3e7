#pragma once

#include <hachure/tests/support/shade_picture.h>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

namespace hachure::test {

/// A stroke as the GPU draws it: lines between five points.
struct DrawnStroke {
    std::uint32_t segment;
    glm::dvec3 point[5]; ///< in the world
    double v[5];         ///< how far along the segment they are, in [0, 1]
};

/// All strokes of segments that the view sees, as the vertex stage places them. `picture` has drawn that view last.
inline std::vector<DrawnStroke> read_strokes(ShadePicture& picture, int most_strokes = 64) {
    const std::filesystem::path here = HACHURE_SOURCE_DIR "/tests/systems/shade_strokes/shaders";
    gpu::ShaderLibrary shaders(here);
    gpu::Program& program = shaders.program({.compute = "test/stroke_points.comp"});
    const std::uint32_t segments = picture.buffers.segment_count();
    const std::size_t count = std::size_t{segments} * static_cast<std::size_t>(most_strokes) * 5;
    if (count == 0) return {};
    const gpu::Buffer points(count * sizeof(glm::vec4), gpu::BufferUsage::immutable, "stroke points");
    program.set("segment_count", segments);
    program.set("most_strokes", most_strokes);
    picture.buffers.ribs.bind_base(gpu::BufferBinding::storage, 2);
    picture.patterns.zigzags.bind_base(gpu::BufferBinding::storage, 3);
    picture.buffers.seen.bind_base(gpu::BufferBinding::storage, 5);
    points.bind_base(gpu::BufferBinding::storage, 6);
    program.use();
    gpu::gl().DispatchCompute((segments + 63) / 64, 1, 1);
    gpu::gl().MemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    std::vector<glm::vec4> values(count);
    points.read(std::span<glm::vec4>(values));
    std::vector<DrawnStroke> strokes;
    for (std::size_t i = 0; i < count; i += 5) {
        if (values[i].w < 0.0f) continue;
        DrawnStroke stroke{static_cast<std::uint32_t>(i / 5 / static_cast<std::size_t>(most_strokes)), {}, {}};
        for (std::size_t k = 0; k < 5; ++k) {
            stroke.point[k] = glm::dvec3(values[i + k]);
            stroke.v[k] = values[i + k].w;
        }
        strokes.push_back(stroke);
    }
    return strokes;
}

} // namespace hachure::test
