// What pixels beside a line stamp, against the formulas of section 4.1.

#include <hachure/components/implicit_brush.h>
#include <hachure/runtime/scene/light_list.h>
#include <hachure/runtime/scene/render_context.h>
#include <hachure/runtime/scene/view.h>
#include <hachure/systems/implicit_brush/stamp_job.h>
#include <hachure/tests/support/gl_fixture.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <numbers>
#include <vector>

namespace hachure {
namespace {

constexpr int stamps_width = 48, stamps_height = 32;
constexpr double line_x = 20.3;

struct Stamp {
    glm::dvec2 place{0.0};
    double radius = 0.0, angle = 0.0;
    glm::dvec3 color{0.0};
    double weight = 0.0;
};

/// An upright line; heights and curvatures grow upwards, from 0 to 1 and from 1 to 2.
class UprightLine {
public:
    explicit UprightLine(gpu::Context& context) : render_(context) {
        view_.width = stamps_width, view_.height = stamps_height;
        render_.view_uniforms.bind(view_, {});
        job_.profile = filled(gpu::Format::rgba32f, [](int x, int y) {
            return glm::vec4(float(line_x - (x + 0.5)), 0.0f, float(height_at(y)), float(1.0 + height_at(y)));
        });
        job_.data = filled(gpu::Format::rgba16f, [](int, int) { return glm::vec4(1.0f, 1.0f, 0.0f, 0.0f); });
        job_.place = texture(gpu::Format::rgba16f);
        job_.ink = texture(gpu::Format::rgba16f);
        job_.rect = {0, 0, stamps_width, stamps_height};
    }
    ~UprightLine() {
        for (const std::uint32_t id : made_) render_.backend->destroy_texture(id);
    }
    UprightLine(const UprightLine&) = delete;
    UprightLine& operator=(const UprightLine&) = delete;

    static double height_at(int y) { return (y + 0.5) / stamps_height; }
    static double distance_at(int x) { return std::abs(line_x - (x + 0.5)); }

    StampJob& job() { return job_; }
    std::uint32_t filled(gpu::Format format, const std::function<glm::vec4(int, int)>& value) {
        const std::uint32_t id = texture(format);
        std::vector<float> texels;
        for (int y = 0; y < stamps_height; ++y)
            for (int x = 0; x < stamps_width; ++x) {
                const glm::vec4 v = value(x, y);
                for (int c = 0; c < 4; ++c) texels.push_back(v[c]);
            }
        render_.backend->texture(id).upload(std::span<const float>(texels), gpu::RowOrder::bottom_first);
        return id;
    }

    std::vector<Stamp> run(const ImplicitBrush& brush) {
        BrushStyle style = brush_style(brush, view_);
        style.scale.z = largest_radius(brush, view_, 1.0f);
        job_.style = &style;
        maker_.run(render_, job_);
        const std::vector<float> places = read(job_.place), inks = read(job_.ink);
        std::vector<Stamp> stamps(std::size_t(stamps_width) * stamps_height);
        for (std::size_t i = 0; i < stamps.size(); ++i) {
            const float *p = &places[4 * i], *c = &inks[4 * i];
            stamps[i].weight = double(c[3]);
            if (c[3] <= 0.0f) continue;
            stamps[i].place = {p[0], p[1]}, stamps[i].radius = double(p[2]), stamps[i].angle = double(p[3]);
            stamps[i].color = glm::dvec3(c[0], c[1], c[2]) / double(c[3]);
        }
        return stamps;
    }

    static const Stamp& at(const std::vector<Stamp>& stamps, int x, int y) {
        return stamps[static_cast<std::size_t>(y * stamps_width + x)];
    }

private:
    std::uint32_t texture(gpu::Format format) {
        made_.push_back(render_.backend->create_texture({stamps_width, stamps_height, format}, "stamps test"));
        return made_.back();
    }
    std::vector<float> read(std::uint32_t id) {
        std::vector<float> texels(4u * stamps_width * stamps_height);
        render_.backend->texture(id).read(std::span<float>(texels), gpu::RowOrder::bottom_first);
        return texels;
    }

    RenderContext render_;
    View view_;
    StampMaker maker_;
    StampJob job_;
    std::vector<std::uint32_t> made_;
};

using StampsTest = test::GlTest;

TEST_P(StampsTest, WeightsAreAGaussianOfTheDistanceTimesAPeakThatFollowsTheHeight) {
    UprightLine line(context());
    const ImplicitBrush brush{.peak = 0.8f, .peak_low = 0.25f, .peak_high = 0.75f, .spread = 2.5f, .cutoff = 0.01f};
    const std::vector<Stamp> stamps = line.run(brush);
    for (int y = 0; y < stamps_height; ++y)
        for (int x = 0; x < stamps_width; ++x) {
            const double peak = 0.8 * std::clamp((UprightLine::height_at(y) - 0.25) / 0.5, 0.0, 1.0);
            const double d = UprightLine::distance_at(x), weight = peak * std::exp(-0.5 * d * d / 6.25);
            if (std::abs(weight - 0.01) < 1e-4) continue;
            ASSERT_NEAR(line.at(stamps, x, y).weight, weight < 0.01 ? 0.0 : weight, 6e-4) << x << " " << y;
        }
}

TEST_P(StampsTest, SizeAndSpreadFollowWhatTheyAreToldTo) {
    UprightLine line(context());
    ImplicitBrush brush{.peak_by = BrushDriver::constant, .size = 6.0f, .weak_size = 2.0f};
    brush.size_by = BrushDriver::curvature, brush.size_low = 1.2f, brush.size_high = 1.6f;
    brush.spread_by = BrushDriver::height, brush.weak_spread = 5.0f, brush.spread = 1.0f;
    brush.spread_low = 0.0f, brush.spread_high = 1.0f;
    const std::vector<Stamp> stamps = line.run(brush);
    for (int y = 0; y < stamps_height; ++y) {
        const double h = UprightLine::height_at(y), spread = 5.0 - 4.0 * h, d = UprightLine::distance_at(22);
        EXPECT_NEAR(line.at(stamps, 22, y).weight, std::exp(-0.5 * d * d / (spread * spread)), 6e-4) << y;
        EXPECT_NEAR(line.at(stamps, 22, y).radius, 2.0 + 4.0 * std::clamp((1.0 + h - 1.2) / 0.4, 0.0, 1.0), 4e-3) << y;
    }
}

TEST_P(StampsTest, ANarrowGaussianIsAsWideAsPixelsNeed) {
    UprightLine line(context());
    const std::vector<Stamp> stamps = line.run({.peak_by = BrushDriver::constant, .spread = 0.0f});
    double sum = 0.0;
    for (int x = 0; x < stamps_width; ++x) sum += line.at(stamps, x, 5).weight;
    EXPECT_NEAR(sum, double(least_spread) * std::sqrt(2.0 * std::numbers::pi), 0.02);
}

TEST_P(StampsTest, StampsTurnWithTheLineAndMoveTowardsTheUpperRight) {
    UprightLine line(context());
    line.job().data = line.filled(gpu::Format::rgba32f, [](int, int) { return glm::vec4(1, 1, 0, 0); }); // theta: right
    ImplicitBrush brush{.peak_by = BrushDriver::constant, .size = 4.0f, .turn = BrushTurn::along, .angle = 0.25f};
    brush.shift_across = 0.5f;
    const Stamp along = line.at(line.run(brush), 20, 9);
    EXPECT_NEAR(std::abs(std::remainder(along.angle - 0.25, std::numbers::pi)), std::numbers::pi / 2, 2e-3);
    EXPECT_NEAR(along.place.x, 4.0 * 0.5 * std::sqrt(0.5), 2e-3);
    EXPECT_NEAR(along.place.y, 0.0, 1e-6);
    brush.turn = BrushTurn::across, brush.shift_across = 0.0f, brush.shift_along = -1.0f;
    const Stamp across = line.at(line.run(brush), 20, 9);
    EXPECT_NEAR(std::remainder(across.angle - 0.25, std::numbers::pi), 0.0, 2e-3);
    EXPECT_NEAR(across.place.y, -4.0 * std::sqrt(0.5), 2e-3);
}

TEST_P(StampsTest, ColoursFollowTheProfileOrWhatIsDrawnAtTheLine) {
    UprightLine line(context());
    ImplicitBrush brush{.peak_by = BrushDriver::constant, .spread = 3.0f, .coloring = BrushColor::profile};
    brush.color = {1, 0, 0}, brush.weak_color = {0, 0, 1};
    const std::vector<Stamp> stamps = line.run(brush);
    EXPECT_NEAR(line.at(stamps, 20, 7).color.r, UprightLine::height_at(7), 2e-3);
    EXPECT_NEAR(line.at(stamps, 20, 7).color.b, 1.0 - UprightLine::height_at(7), 2e-3);
    line.job().color = line.filled(gpu::Format::rgba32f, [](int x, int) { return glm::vec4(x == 20, 0.5, 0, 1); });
    brush.coloring = BrushColor::surface;
    const std::vector<Stamp> shaded = line.run(brush);
    for (const int x : {17, 20, 24})
        EXPECT_NEAR(line.at(shaded, x, 7).color.r, 1.0, 2e-3) << "the line's, not the pixel's";
}

TEST_P(StampsTest, NoiseIsTheLinesAndInterruptsMovesShrinks) {
    UprightLine line(context());
    const auto noise = [](int x, int y) {
        return x == 20 ? glm::vec4(0.5f, float(y) / 16.0f - 1.0f, 0.25f, -0.75f) : glm::vec4(1.0f);
    };
    line.job().noise = line.filled(gpu::Format::rgba32f, noise);
    ImplicitBrush brush{.peak_by = BrushDriver::constant, .spread = 3.0f, .size = 4.0f};
    brush.interruption = 0.5f, brush.wobble = 2.0f, brush.size_noise = 0.4f;
    const std::vector<Stamp> stamps = line.run(brush);
    EXPECT_EQ(line.at(stamps, 20, 4).weight, 0.0);
    EXPECT_GT(line.at(stamps, 20, 28).weight, 0.9);
    const Stamp moved = line.at(stamps, 22, 28);
    const double radius = 4.0 * (1.0 - 0.4 * 0.75);
    EXPECT_NEAR(moved.radius, radius, 4e-3);
    EXPECT_NEAR(moved.place.x, radius * 2.0 * 0.25, 4e-3);
    EXPECT_NEAR(moved.place.y, radius * 2.0 * -0.75, 4e-3);
}

TEST_P(StampsTest, WithoutALineOrWithNumbersThatAreNoneNothingIsStamped) {
    UprightLine line(context());
    const float none = std::numeric_limits<float>::quiet_NaN(), endless = std::numeric_limits<float>::infinity();
    line.job().profile = line.filled(gpu::Format::rgba32f, [&](int x, int) {
        const std::vector<glm::vec4> cases{{1e4, 1e4, 0, 0},   {0, 0, none, none}, {none, 0, 1, 1},
                                           {endless, 0, 1, 1}, {0, 0, -1, 0},      {0, 0, 0, 1}};
        return cases[static_cast<std::size_t>(x) % cases.size()];
    });
    for (const Stamp& stamp : line.run({.peak_by = BrushDriver::constant})) ASSERT_EQ(stamp.weight, 0.0);
}

HACHURE_INSTANTIATE_GL_TESTS(StampsTest);

} // namespace
} // namespace hachure
