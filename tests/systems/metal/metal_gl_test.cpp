#include <hachure/components/metal.h>
#include <hachure/systems/metal/metal_frame.h>
#include <hachure/systems/metal/stripe_layout.h>
#include <hachure/tests/support/drawn_scene.h>
#include <hachure/tests/support/gl_fixture.h>

#include <fmt/format.h>
#include <glm/gtc/constants.hpp>

#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <string>

#include "metal_closed_form.h"
#include "metal_scene.h"

namespace hachure::test {
namespace {

constexpr Canvas metal_canvas{192, 144};
constexpr double tolerance = 1.0 / 255.0;
constexpr double tau = 2.0 * std::numbers::pi;

/// Its faces lie up to 1 - cos(pi/4096) = 3e-7 radii inside the cylinder: 4e-4 pixels at the nearest, 1/50000 stripe.
const geometry::Shape& fine_cylinder() {
    static const geometry::Shape shape = geometry::cylinder(1.0, 4.0, 4096);
    return shape;
}

/// A cylinder seen from somewhere, with 20 sets of 20 stripes about it.
struct Trial {
    std::string name;
    Metal metal;
    bool orthographic = true;
    glm::quat rotation{1.0f, 0.0f, 0.0f, 0.0f}; ///< of the cylinder
    dvec3 light{0.03, 0.3, 1.0};                ///< towards it; its stripe is in view at all distances
    glm::vec3 scale{1.0f};
};

/// The camera for which stripes are `width` pixels wide where they are nearest.
std::pair<Camera, Transform> camera_for(const Trial& trial, double width) {
    const double stripes =
        trial.metal.count * double(trial.metal.sets) * (trial.metal.source == MetalSource::curvature ? 2.0 : 1.0);
    const double pixels_per_radius = width * stripes / tau / double(trial.scale.x);
    if (trial.orthographic)
        return {{.projection = Projection::orthographic,
                 .ymag = static_cast<float>(0.5 * metal_canvas.height / pixels_per_radius),
                 .zfar = 100.0f},
                {.translation = {0.0f, 0.1f, 20.0f}}};
    const double yfov = 0.6, pixels_per_slope = 0.5 * metal_canvas.height / std::tan(0.5 * yfov);
    const double distance = pixels_per_slope / pixels_per_radius;
    return {{.yfov = static_cast<float>(yfov), .znear = 0.01f},
            {.translation = {0.1f, 0.2f, static_cast<float>(distance + double(trial.scale.x))}}};
}

struct Worst {
    double linear = 0.0; ///< off the average over the pixel, on which stripes count as evenly wide
    double pixel = 0.0; ///< off the average of 32x32 rays through it, where the surface faces the eye within 45 degrees
    int checked = 0, checked_by_rays = 0;
    double brightest = 0.0;
};

/// A pixel of the picture and what the ray casting says about it.
class Reference {
public:
    Reference(const Trial& trial, const Camera& camera, const Transform& place, double phase, double direction)
        : cylinder_{{.rotation = trial.rotation, .scale = trial.scale}, 2.0}, camera_(camera, place, metal_canvas),
          phase_(phase) {
        const Metal& metal = trial.metal;
        const bool curvature = metal.source == MetalSource::curvature;
        pattern_ = {intensities_of(metal), curvature, metal.count * double(metal.sets) * (curvature ? 2.0 : 1.0)};
        per_radian_ = direction * pattern_.per_turn / tau;
        const dvec3 l = glm::normalize(trial.light);
        const dvec3 faced =
            metal.highlight == MetalHighlight::halfway ? l + glm::dquat(place.rotation) * dvec3(0.0, 0.0, 1.0) : l;
        pattern_.light = stripe(cylinder_.angle_towards(faced));
        pattern_.white = double(metal.light_stripe);
    }

    [[nodiscard]] std::optional<CastCylinder::Meeting> meet(double column, double row) const {
        // Rays are as far apart everywhere.
        const Ray at = camera_.ray(0, 0), right = camera_.ray(1, 0), down = camera_.ray(0, 1);
        return cylinder_.meet(
            {at.origin + column * (right.origin - at.origin) + row * (down.origin - at.origin),
             at.direction + column * (right.direction - at.direction) + row * (down.direction - at.direction)});
    }
    [[nodiscard]] bool inside(double column, double row) const {
        for (const double x : {-2.0, 2.0})
            for (const double y : {-2.0, 2.0})
                if (!meet(column + x, row + y)) return false;
        return true;
    }
    /// Averages over the footprint that the derivatives at the middle of the pixel give.
    [[nodiscard]] double by_derivatives(double column, double row) const {
        constexpr double h = 1e-4;
        const auto change = [&](double x, double y) {
            const double a = meet(column + x, row + y)->angle, b = meet(column - x, row - y)->angle;
            return per_radian_ * std::remainder(a - b, tau) / (2.0 * h);
        };
        return pattern_.average(stripe(meet(column, row)->angle), change(h, 0.0), change(0.0, h));
    }
    [[nodiscard]] double by_rays(double column, double row) const {
        constexpr int n = 32;
        double sum = 0.0;
        for (int y = 0; y < n; ++y)
            for (int x = 0; x < n; ++x)
                sum += pattern_.at(stripe(meet(column + (x + 0.5) / n - 0.5, row + (y + 0.5) / n - 0.5)->angle));
        return sum / (n * n);
    }

private:
    [[nodiscard]] double stripe(double angle) const { return phase_ + per_radian_ * angle; }

    CastCylinder cylinder_;
    RayCamera camera_;
    StripePattern pattern_;
    double phase_ = 0.0, per_radian_ = 0.0;
};

/// Where the stripes of source `curvature` begin and which way they run is the layout's choice: read off it.
std::pair<double, double> phase_and_direction(const Trial& trial, const SurfaceMesh& mesh) {
    if (trial.metal.source != MetalSource::curvature) return {0.0, 1.0};
    const geometry::StripeMesh stripes = lay_stripes(mesh, trial.metal);
    // The first triangle of the wall: its corners 0 and 2 lie a 4096th of a turn apart.
    const auto u = [&](int corner) {
        return double(stripes.coordinate[stripes.indices[static_cast<std::size_t>(corner)]]);
    };
    const auto angle = [&](int corner) {
        const glm::vec3 p = mesh.positions[stripes.source_vertex[stripes.indices[static_cast<std::size_t>(corner)]]];
        return std::atan2(-double(p.z), double(p.x));
    };
    const double direction = (u(1) - u(0)) * std::remainder(angle(1) - angle(0), tau) > 0.0 ? 1.0 : -1.0;
    const double sets_per_radian = direction * 2.0 * double(trial.metal.sets) / tau;
    return {trial.metal.count * (u(0) - sets_per_radian * angle(0)), direction};
}

Worst compare(gpu::Context& context, const Trial& trial, double width) {
    DrawnScene scene(context, metal_canvas);
    const SurfaceMesh mesh = surface_mesh(fine_cylinder());
    scene.world().add(scene.add(mesh, {.rotation = trial.rotation, .scale = trial.scale}), trial.metal);
    const auto [camera, place] = camera_for(trial, width);
    scene.add(camera, place);
    add_light(scene, glm::vec3(trial.light));
    const assets::Image color = draw_linear(scene);

    const auto [phase, direction] = phase_and_direction(trial, mesh);
    const Reference reference(trial, camera, place, phase, direction);
    Worst worst;
    for (int row = 0; row < metal_canvas.height; row += 5)
        for (int column = 0; column < metal_canvas.width; ++column) {
            if (!reference.inside(column, row)) continue;
            const double drawn = double(color.f32()[3 * (row * metal_canvas.width + column)]);
            worst.linear = std::max(worst.linear, std::abs(drawn - reference.by_derivatives(column, row)));
            worst.brightest = std::max(worst.brightest, drawn);
            ++worst.checked;
            if (row % 10 != 0 || column % 3 != 0 || reference.meet(column, row)->facing < 0.7071) continue;
            worst.pixel = std::max(worst.pixel, std::abs(drawn - reference.by_rays(column, row)));
            ++worst.checked_by_rays;
        }
    return worst;
}

Metal metal_of(MetalSource source) {
    return {.source = source, .sets = source == MetalSource::curvature ? 10.0f : 20.0f, .seed = 3};
}

glm::quat tilted() { return glm::angleAxis(0.5f, glm::normalize(glm::vec3(0.3f, 0.1f, 1.0f))); }

std::vector<Trial> trials() {
    Metal towards = metal_of(MetalSource::texture_u), other = metal_of(MetalSource::around_axis);
    towards.highlight = MetalHighlight::light;
    other.low = 0.9f;
    other.high = 0.2f;
    other.light_stripe = 0.6f;
    // Turned so that the seams of angle and texture coordinate are in the middle of the picture.
    const glm::quat seam_in_front = glm::angleAxis(-1.57f, glm::vec3(0, 1, 0));
    return {{"around_axis", metal_of(MetalSource::around_axis), true, seam_in_front},
            {"texture_u", metal_of(MetalSource::texture_u), true, seam_in_front},
            {"curvature", metal_of(MetalSource::curvature)},
            {"texture_u, tilted, perspective, light itself", towards, false, tilted()},
            {"around_axis, tilted, perspective, other range", other, false, tilted()}};
}

constexpr std::array widths{0.2, 0.35, 0.7, 1.0, 2.0, 5.0, 20.0};

using MetalTest = GlTest;

/// The colours of a picture that differs from another in tint or tone are made of that one's greys.
TEST_P(MetalTest, TintAndTonesAreMadeOfTheStripes) {
    SurfaceMaterial brass;
    brass.base_color = {0.8f, 0.6f, 0.2f, 1.0f};
    const auto draw = [&](const Metal& metal, bool normals) {
        MetalScene scene(context(), metal_canvas, surface_mesh(geometry::torus(1.0, 0.4, 96, 48), brass), metal,
                         {1, 1, 0}, 1.5f, {.rotation = tilted()});
        if (!normals) return scene.draw();
        scene.scene.renderer().request_aov("normal");
        scene.scene.renderer().render_frame();
        return scene.scene.renderer().read_aov("normal");
    };
    Metal grey{.source = MetalSource::texture_v, .seed = 4}, stripes = grey, tinted = grey, warm = grey, half = grey;
    stripes.light_stripe = 0.0f;
    tinted.tint = 0.75f;
    warm.cool_to_warm = 1.0f;
    half.cool_to_warm = 0.5f;
    const assets::Image c = draw(grey, false), dull = draw(stripes, false), t = draw(tinted, false),
                        w = draw(warm, false), h = draw(half, false), n = draw(grey, true);
    const dvec3 l = glm::normalize(dvec3(1, 1, 0)), k_d(0.8, 0.6, 0.2);
    int checked = 0, white = 0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(metal_canvas.width * metal_canvas.height); ++i) {
        const dvec3 normal(n.f32()[3 * i], n.f32()[3 * i + 1], n.f32()[3 * i + 2]);
        if (glm::length(normal) < 0.5) continue;
        ++checked;
        const double intensity = double(c.f32()[3 * i]), without = double(dull.f32()[3 * i]);
        EXPECT_GE(without, 0.0);
        EXPECT_LE(without, 0.5);
        const double weight = 0.5 + 0.5 * glm::dot(normal, l);
        const dvec3 cool = dvec3(0, 0, double(warm.b)) + double(warm.alpha) * intensity;
        const dvec3 tone =
            weight * (dvec3(double(warm.y), double(warm.y), 0) + double(warm.beta) * intensity) + (1.0 - weight) * cool;
        white += intensity > 0.9 ? 1 : 0;
        for (int channel = 0; channel < 3; ++channel) {
            const std::size_t at = 3 * i + static_cast<std::size_t>(channel);
            EXPECT_NEAR(double(w.f32()[at]), tone[channel], 1e-5);
            EXPECT_NEAR(double(h.f32()[at]), 0.5 * (tone[channel] + intensity), 1e-5);
            // Only stripes are tinted: away from the white one.
            const double least = intensity == without ? intensity * (0.25 + 0.75 * k_d[channel]) : 0.0;
            const double most = intensity == without ? least : intensity;
            EXPECT_GE(double(t.f32()[at]), least - 1e-5);
            EXPECT_LE(double(t.f32()[at]), most + 1e-5);
        }
    }
    EXPECT_GT(checked, 3000);
    EXPECT_GT(white, 50);
}

/// Far away every pixel shows the mean of the stripes.
TEST_P(MetalTest, FarAwayTheMeanIsLeft) {
    for (const MetalSource source : {MetalSource::texture_u, MetalSource::around_axis, MetalSource::along_axis}) {
        const Metal metal{.source = source, .sets = 400, .seed = 3, .light_stripe = 0.0f};
        MetalScene scene(context(), metal_canvas, surface_mesh(geometry::cylinder(1.0, 4.0, 256)), metal, {1, 1, 1},
                         4.0f, {.rotation = tilted()});
        const assets::Image picture = scene.draw();
        const std::vector<double> set = intensities_of(metal);
        double mean = 0.0;
        for (const double c : set) mean += c / static_cast<double>(set.size());
        int checked = 0;
        // In the middle: beyond the ends and at the outline there is the background.
        for (int row = metal_canvas.height / 2 - 8; row < metal_canvas.height / 2 + 8; ++row)
            for (int column = metal_canvas.width / 2 - 8; column < metal_canvas.width / 2 + 8; ++column) {
                EXPECT_NEAR(double(picture.f32()[3 * (row * metal_canvas.width + column)]), mean, 0.02);
                ++checked;
            }
        EXPECT_EQ(checked, 256);
    }
}

void expect_closed_form(gpu::Context& context, const Trial& trial) {
    double worst_linear = 0.0, worst_pixel = 0.0;
    for (const double width : widths) {
        SCOPED_TRACE(fmt::format("{}: stripes of {} px", trial.name, width));
        const Worst worst = compare(context, trial, width);
        worst_linear = std::max(worst_linear, worst.linear);
        worst_pixel = std::max(worst_pixel, worst.pixel);
        EXPECT_LE(worst.linear, tolerance);
        EXPECT_LE(worst.pixel, tolerance);
        EXPECT_GT(worst.checked, 120);
        EXPECT_GT(worst.checked_by_rays, 8);
        // White is seen where stripes are not narrower than pixels.
        EXPECT_GT(worst.brightest, width < 2.0 ? 0.25 : 0.5 + 0.35 * double(trial.metal.light_stripe));
    }
    fmt::print("{}: {:.5f} off the filtered ramp, {:.5f} off the pixel's rays (1/255 = {:.5f})\n", trial.name,
               worst_linear, worst_pixel, tolerance);
}

TEST_P(MetalTest, CylinderMatchesTheFilteredRamp) {
    for (const Trial& trial : trials()) expect_closed_form(context(), trial);
}

HACHURE_INSTANTIATE_GL_TESTS_ONCE(MetalTest);

} // namespace
} // namespace hachure::test
