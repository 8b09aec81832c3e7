// Lines of surfaces whose topology changes: what they weigh changes steadily, since no line is traced that would have
// to be cut or joined (section 1 of Vergne 2011).

#include <hachure/runtime/scene/light_list.h>
#include <hachure/runtime/scene/view.h>
#include <hachure/tests/support/gl_fixture.h>
#include <hachure/tests/systems/implicit_brush/line_energy.h>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <span>
#include <vector>

namespace hachure::test {
namespace {

constexpr int marched_size = 96; // px; a pixel is a metre

/// No farther than the surface is from a place, negative inside; the picture's middle is (0, 0), the eye is at z =
/// +inf.
using Distance = std::function<double(glm::dvec3)>;

/// Depth and normal as the eye sees them. Each ray is marched by what the distance allows: nothing of it is shared with
/// what draws surfaces.
struct MarchedSurface {
    std::vector<float> depths;  ///< metres from the plane z = 64; 0 where there is nothing
    std::vector<float> normals; ///< 4 each

    explicit MarchedSurface(const Distance& distance) {
        for (int y = 0; y < marched_size; ++y)
            for (int x = 0; x < marched_size; ++x) {
                glm::dvec3 p(pixel_center(x, y) - 0.5 * marched_size, 48.0);
                for (double d = 1.0; d > 1e-6 && p.z > -48.0;) p.z -= d = distance(p);
                const bool hit = p.z > -48.0;
                const glm::dvec3 n = hit ? normal(distance, p) : glm::dvec3(0.0);
                depths.push_back(hit ? static_cast<float>(64.0 - p.z) : 0.0f);
                for (const double c : {n.x, n.y, n.z, 0.0}) normals.push_back(static_cast<float>(c));
            }
    }

private:
    static glm::dvec3 normal(const Distance& distance, glm::dvec3 p) {
        constexpr double h = 1e-5;
        glm::dvec3 gradient;
        for (int i = 0; i < 3; ++i) {
            glm::dvec3 step(0.0);
            step[i] = h;
            gradient[i] = distance(p + step) - distance(p - step);
        }
        return glm::normalize(gradient);
    }
};

/// Finds features in marched surfaces.
class MarchedFinding {
public:
    MarchedFinding(RenderContext& render, const FeatureSettings& settings)
        : render_(render), settings_(settings), finding_(render, settings, marched_size, marched_size) {
        none_ = make(gpu::Format::depth32f), depth_ = make(gpu::Format::r32f), normal_ = make(gpu::Format::rgba32f);
        render.backend->texture(none_).clear(std::array{0.0f, 0.0f, 0.0f, 0.0f});
        render.view_uniforms.bind({.view_from_world = glm::mat4(1.0f), .width = marched_size, .height = marched_size},
                                  LightList{});
    }
    ~MarchedFinding() {
        for (const std::uint32_t id : {none_, depth_, normal_}) render_.backend->destroy_texture(id);
    }
    MarchedFinding(const MarchedFinding&) = delete;
    MarchedFinding& operator=(const MarchedFinding&) = delete;

    std::vector<PixelProfile> find(const MarchedSurface& surface) {
        using gpu::RowOrder;
        render_.backend->texture(depth_).upload(std::span<const float>(surface.depths), RowOrder::bottom_first);
        render_.backend->texture(normal_).upload(std::span<const float>(surface.normals), RowOrder::bottom_first);
        const bool contours = settings_.feature == BrushFeature::contours;
        SlopeJob{.kind = contours ? SlopeKind::breaks : SlopeKind::surface,
                 .depth_buffer = none_,
                 .normals = normal_,
                 .picture_depth = depth_,
                 .picture_normals = normal_,
                 .half_break = contours ? 0.5f * settings_.window : SlopeJob{}.half_break,
                 .rect = {0, 0, marched_size, marched_size},
                 .to = finding_.slope_texture()}
            .run(render_);
        finding_.run();
        EXPECT_TRUE(finding_.all_finite());
        return finding_.profiles();
    }

private:
    std::uint32_t make(gpu::Format format) {
        return render_.backend->create_texture({marched_size, marched_size, format}, "marched");
    }

    RenderContext& render_;
    FeatureSettings settings_;
    FeatureFinding finding_;
    std::uint32_t none_ = 0, depth_ = 0, normal_ = 0;
};

/// Two balls of radius 15, so far apart, melting together: minus the logarithm of the sum of exponentials, which has
/// all derivatives and is nowhere steeper than a distance.
Distance melting_balls(double apart) {
    return [=](glm::dvec3 p) {
        constexpr double k = 2.0;
        const glm::dvec3 middle = 0.5 * apart * glm::dvec3(std::cos(0.3), std::sin(0.3), 0.0);
        const double a = glm::distance(p, middle) - 15.0, b = glm::distance(p, -middle) - 15.0, near = std::min(a, b);
        return near - k * std::log(std::exp((near - a) / k) + std::exp((near - b) / k));
    };
}

/// A ring of radius 20 seen from above, so thick.
Distance ring(double thickness) {
    return [=](glm::dvec3 p) {
        const glm::dvec2 around(glm::length(glm::dvec2(p.x, p.y) - glm::dvec2(0.3, -0.4)) - 20.0, p.z);
        return glm::length(around) - thickness;
    };
}

/// What a contour has for each pixel of its length: a little less than the Gaussian of a line that every pixel places
/// exactly, since where depth breaks off is known to a pixel.
constexpr double energy_of_a_pixel = 2.3;

class BrushTopologyTest : public GlTest {
protected:
    /// Energies of a feature while a surface changes by `steps` steps of half a metre.
    std::vector<double> energies(BrushFeature feature, int steps, const std::function<Distance(double)>& surface) {
        RenderContext render(context());
        MarchedFinding finding(render, {.feature = feature, .diffusion = 2, .fits = 3});
        std::vector<double> all;
        for (int i = 0; i <= steps; ++i)
            all.push_back(line_energy(finding.find(MarchedSurface(surface(0.5 * i))), 0.2, 0.5));
        RecordProperty("energies", ::testing::PrintToString(all));
        return all;
    }
};

/// Two outlines become one, and a valley appears where they did.
TEST_P(BrushTopologyTest, BallsMelt) {
    const auto balls = [](double moved) { return melting_balls(40.0 - moved); };
    const std::vector<double> contours = energies(BrushFeature::contours, 28, balls);
    const double apart = energy_of_a_pixel * 4.0 * std::numbers::pi * 15.0;
    EXPECT_NEAR(contours.front(), apart, 0.05 * apart);
    EXPECT_LE(contours.back(), 0.85 * contours.front());
    EXPECT_LE(largest_step(contours), 0.05 * apart);

    const std::vector<double> valleys = energies(BrushFeature::valleys, 28, balls);
    EXPECT_LE(valleys.front(), 1.0) << "balls have none";
    EXPECT_GE(valleys.back(), 20.0);
    EXPECT_LE(largest_step(valleys), 0.25 * valleys.back())
        << "a neck as wide as the picture is coarse may appear at once";
}

/// The hole of a ring closes: an outline shrinks to a point, and leaves a pit.
TEST_P(BrushTopologyTest, ARingCloses) {
    const auto thickness = [](double changed) { return 13.0 + 0.7 * changed; };
    const auto growing = [&](double changed) { return ring(thickness(changed)); };
    const std::vector<double> contours = energies(BrushFeature::contours, 27, growing);
    for (std::size_t i = 0; i < contours.size(); ++i) {
        const double thick = thickness(0.5 * static_cast<double>(i));
        const double length = 2.0 * std::numbers::pi * (20.0 + thick + std::max(20.0 - thick, 0.0));
        EXPECT_NEAR(contours[i], energy_of_a_pixel * length, 0.05 * energy_of_a_pixel * length) << thick;
    }
    const std::vector<double> valleys = energies(BrushFeature::valleys, 27, growing);
    EXPECT_GT(valleys.back(), 100.0);
    EXPECT_LE(largest_step(valleys), 0.1 * *std::ranges::max_element(valleys));
}

HACHURE_INSTANTIATE_GL_TESTS_ONCE(BrushTopologyTest);

} // namespace
} // namespace hachure::test
