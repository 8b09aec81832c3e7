#include <hachure/components/abstracted_lines.h>
#include <hachure/components/light.h>
#include <hachure/runtime/gpu/gl.h>
#include <hachure/tests/benchmarks/abstracted_lines_drawn_bars.h>
#include <hachure/tests/support/drawn_scene.h>
#include <hachure/tests/support/line_finding.h>

#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace hachure::bench {
namespace {

/// A plate of that width, twice as long as the picture is wide, before the eye.
geometry::Shape plate(double width, int size) {
    const float x = 0.5f * static_cast<float>(width), y = static_cast<float>(size);
    return {.positions = {{-x, -y, 0}, {x, -y, 0}, {x, y, 0}, {-x, y, 0}},
            .normals = std::vector<glm::vec3>(4, {0, 0, 1}),
            .indices = {0, 1, 2, 0, 2, 3}};
}

} // namespace

DrawnBars::DrawnBars(gpu::Context& context, int samples, double width, double line_width, int angles)
    : width_(width), line_width_(line_width), size_(2 * static_cast<int>(4.0 * line_width + 10.0)) {
    test::DrawnScene scene(context, Canvas{size_, size_});
    // A metre of the scene is a pixel; the light comes from behind, so that the plate is black.
    const Entity bar = scene.add(test::surface_mesh(plate(width, size_)));
    scene.world().add(bar, AbstractedLines{});
    scene.world().create_with(Transform{.rotation = glm::angleAxis(std::numbers::pi_v<float>, glm::vec3(0, 1, 0))},
                              Light{});
    const Entity camera =
        scene.add(Camera{.projection = Projection::orthographic, .ymag = 0.5f * static_cast<float>(size_)},
                  {.translation = {0, 0, 10}});
    scene.world().add(camera, ToneImage{.quality = ToneQuality::custom, .samples = samples});
    scene.renderer().request_aov("tone");
    for (int k = 0; k < angles; ++k) {
        const double angle = std::numbers::pi * (k + 0.3) / angles;
        const auto line = test::TrueLine::through_middle(size_, size_, angle, test::spread_phase(k));
        const glm::dvec2 middle = line.normal * test::spread_phase(k);
        scene.world().get_mutable<Transform>(bar) = {
            .translation = {static_cast<float>(middle.x), static_cast<float>(middle.y), 0.0f},
            .rotation = glm::angleAxis(static_cast<float>(angle), glm::vec3(0, 0, 1))};
        scene.renderer().render_frame();
        bars_.push_back({line, tones_of(scene.renderer().read_aov("tone"))});
    }
}

test::LineScore DrawnBars::score(RenderContext& render, const Finding& finding) const {
    AbstractedLines lines = test::plain_lines(line_width_, std::min(1.0, width_ / line_width_));
    lines.beta = finding.beta;
    test::LineFinding search(render, lines, finding.quality, size_, size_);
    const double truth = std::max(width_, 1.0);
    test::LineScore score(truth);
    const int rim = static_cast<int>(3.0 * line_width_);
    for (const Bar& bar : bars_) {
        const std::vector<test::PixelLine> found = search.find(bar.tones);
        for (int y = rim; y < size_ - rim; ++y)
            for (int x = rim; x < size_ - rim; ++x) {
                const double distance = bar.line.distance(test::pixel_center(x, y));
                const test::PixelLine& pixel = found[static_cast<std::size_t>(y * size_ + x)];
                if (std::abs(distance) <= 0.5 * truth)
                    score.add(distance, pixel.dark, -glm::dot(pixel.offset, bar.line.normal));
            }
    }
    return score;
}

std::vector<int> offered_samples(const gpu::Context& context) {
    std::array<GLint, 16> counts{};
    gpu::gl().GetInternalformativ(GL_TEXTURE_2D_MULTISAMPLE, GL_RG16, GL_SAMPLES, static_cast<GLsizei>(counts.size()),
                                  counts.data());
    std::vector<int> offered = {1};
    for (const int samples : {2, 4})
        if (samples <= context.limits().max_samples && std::ranges::find(counts, samples) != counts.end())
            offered.push_back(samples);
    return offered;
}

} // namespace hachure::bench
