#include <hachure/components/toon.h>
#include <hachure/runtime/assets/image_file.h>
#include <hachure/runtime/scene/light_list.h>
#include <hachure/systems/toon/toon.h>
#include <hachure/tests/support/drawn_scene.h>
#include <hachure/tests/support/gl_fixture.h>
#include <hachure/tests/support/temp_folder.h>

#include <fmt/format.h>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <string>

#include "closed_form.h"

namespace hachure::test {
namespace {

constexpr Canvas canvas{192, 144};

/// As in gooch_gl_test.cpp: the faces of this sphere lie up to 1.3e-5 radii inside it.
const geometry::Shape& fine_sphere() {
    static const geometry::Shape shape = geometry::icosphere(1.0, 7);
    return shape;
}

struct Trial {
    std::string name;
    ToonScene scene;
    Toon toon;
    std::optional<assets::Image> ramp{};
};

/// Turned so that it comes from direction `from`.
ToonLight light_from(const glm::vec3& from, const glm::vec3& color = glm::vec3(1.0f), float intensity = 1.0f) {
    const glm::vec3 to = glm::normalize(from);
    const glm::quat turn = glm::quatLookAt(-to, glm::vec3(0, 1, 0));
    return {{.color = color, .intensity = intensity}, {.translation = 3.0f * to, .rotation = turn}};
}

ToonScene scene_with(std::vector<ToonLight> lights) {
    const glm::quat turn = glm::angleAxis(0.6f, glm::vec3(0, 1, 0)) * glm::angleAxis(-0.4f, glm::vec3(1, 0, 0));
    return {.canvas = canvas,
            .camera = {.yfov = 0.7f},
            .eye = {.translation = turn * glm::vec3(0.05f, 0.1f, 3.6f), .rotation = turn},
            .lights = std::move(lights)};
}

assets::Image draw_color(gpu::Context& context, const ToonScene& scene, const Toon& toon,
                         const geometry::Shape& shape = fine_sphere()) {
    DrawnScene drawn(context, scene.canvas);
    drawn.renderer().request_aov("color");
    SurfaceMaterial material;
    material.base_color = glm::vec4(glm::vec3(scene.color), 1.0f);
    drawn.world().add(drawn.add(surface_mesh(shape, material), {.scale = glm::vec3(float(scene.radius))}), toon);
    drawn.add(scene.camera, scene.eye);
    for (const ToonLight& light : scene.lights) drawn.world().create_with(light.place, light.light);
    drawn.renderer().render_frame();
    return drawn.renderer().read_aov("color");
}

/// Values over the picture, and how they change over a pixel: differences within blocks of 2x2, as GLSL defines them.
struct Field {
    std::vector<double> values;

    [[nodiscard]] double at(int column, int row) const { return values[std::size_t(row * canvas.width + column)]; }
    [[nodiscard]] double width(int column, int row) const {
        const int x = column & ~1, y = row & ~1;
        return std::max(1e-6, std::hypot(at(x + 1, row) - at(x, row), at(column, y + 1) - at(column, y)));
    }
};

class Expected {
public:
    explicit Expected(const Trial& trial) : trial_(trial) {
        for (int row = 0; row < canvas.height; ++row)
            for (int column = 0; column < canvas.width; ++column) {
                const ToonPoint point = trial.scene.cast(column + 0.5, row + 0.5);
                points_.push_back(point);
                tone_.values.push_back(point.hit ? trial.scene.tone(point, trial.toon.wrap) : 0.0);
                away_.values.push_back(point.hit ? 1.0 - std::abs(glm::dot(point.normal, point.to_eye)) : 0.0);
                angle_.values.push_back(point.hit ? highlight_angle(point) : 0.0);
            }
    }

    /// Whether all pixels within 2 show the sphere, or none does; and whether it is seen at no grazing angle, where
    /// what its faces lie inside of it moves a ray's hit far along it: edges of tones follow, by a part of a pixel.
    [[nodiscard]] bool away_from_outlines(int column, int row) const {
        for (int y = std::max(0, row - 2); y <= std::min(canvas.height - 1, row + 2); ++y)
            for (int x = std::max(0, column - 2); x <= std::min(canvas.width - 1, column + 2); ++x)
                if (point(x, y).hit != point(column, row).hit) return false;
        return !point(column, row).hit || away_.at(column, row) < 0.4;
    }

    [[nodiscard]] const ToonPoint& point(int column, int row) const {
        return points_[std::size_t(row * canvas.width + column)];
    }

    [[nodiscard]] dvec3 color(int column, int row) const {
        const ToonPoint& at = point(column, row);
        if (!at.hit) return dvec3(1.0);
        const Toon& toon = trial_.toon;
        const double tone = tone_.at(column, row), width = tone_.width(column, row);
        const double detail = toon_detail(trial_.scene, toon, at);
        dvec3 color = trial_.ramp ? ramped(toon, *trial_.ramp, tone, width, detail) : banded(toon, tone, width, detail);
        if (!trial_.ramp || toon.ramp_use == RampUse::multiply) color *= trial_.scene.color;
        const double lit = toon.rim_lit_only ? part_above(tone, toon.dark_edge, width, 0.0) : 1.0;
        const double rim =
            double(toon.rim) * lit *
            part_above(away_.at(column, row), 1.0 - double(toon.rim_width), away_.width(column, row), 0.0);
        color = (1.0 - rim) * color + rim * dvec3(toon.rim_color);
        const double spread = angle_.width(column, row);
        const double shine =
            double(toon.specular) *
            std::min(1.0 - part_above(angle_.at(column, row), 1.0, spread, 0.0), glm::pi<double>() / (spread * spread));
        color = (1.0 - shine) * color + shine * dvec3(toon.specular_color);
        return color * trial_.scene.light_color(at, toon.wrap);
    }

private:
    /// Of the sum of Blinn and Phong's highlights, relative to the angle at which one alone is at half.
    [[nodiscard]] double highlight_angle(const ToonPoint& at) const {
        double sum = 0.0;
        const double size = trial_.toon.specular_size;
        for (const ToonLight& light : trial_.scene.lights) {
            const dvec3 l = ToonScene::towards(light, at.position);
            const double cosine = glm::dot(at.normal, glm::normalize(l + at.to_eye));
            const double facing = std::clamp(glm::dot(at.normal, l) / 0.1, 0.0, 1.0);
            sum += ToonScene::strength(light) / trial_.scene.strongest() * ToonScene::reach(light, at.position) *
                   facing * facing * (3.0 - 2.0 * facing) *
                   std::exp2(2.0 / (size * size) * std::log(std::max(cosine, 1e-12)));
        }
        return std::sqrt(std::max(0.0, -std::log2(std::max(sum, 1e-30))));
    }

    const Trial& trial_;
    std::vector<ToonPoint> points_;
    Field tone_, away_, angle_;
};

struct Difference {
    double worst = 0.0;
    int checked = 0, drawn = 0;
    std::string where{};
};

Difference compare(gpu::Context& context, const Trial& trial) {
    const assets::Image color = draw_color(context, trial.scene, trial.toon);
    const Expected expected(trial);
    Difference result;
    for (int row = 0; row < canvas.height; ++row)
        for (int column = 0; column < canvas.width; ++column) {
            if (!expected.away_from_outlines(column, row)) continue;
            const dvec3 wanted = expected.color(column, row);
            for (int c = 0; c < 3; ++c) {
                const double off = std::abs(double(color.f32()[3 * (row * canvas.width + column) + c]) - wanted[c]);
                if (off > result.worst) result.where = fmt::format("column {}, row {}", column, row);
                result.worst = std::max(result.worst, off);
            }
            ++result.checked;
            result.drawn += expected.point(column, row).hit ? 1 : 0;
        }
    return result;
}

/// A picture of noise: every texel matters.
assets::Image noise_ramp(int width, int height) {
    assets::Image image = assets::make_image(width, height, 3, assets::PixelType::u8);
    std::uint32_t state = 7;
    for (int i = 0; i < 3 * width * height; ++i) {
        state = state * 1664525u + 1013904223u;
        image.u8()[i] = static_cast<std::uint8_t>(state >> 24);
    }
    return image;
}

std::vector<Trial> band_trials() {
    const ToonLight sun = light_from({1.0f, 0.5f, -0.1f}),
                    side = light_from({-1.0f, 0.2f, 0.6f}, {1, 0.6f, 0.3f}, 0.6f);
    ToonLight lamp = light_from({0.4f, 0.9f, 1.0f}, glm::vec3(1), 50.0f), spot = light_from({0.9f, 0.5f, 1.0f});
    lamp.light.kind = LightKind::point;
    lamp.light.range = 3.4f;
    spot.light.kind = LightKind::spot;
    spot.light.inner_cone = 0.1f;
    spot.light.outer_cone = 0.4f;
    ToonScene orthographic = scene_with({sun});
    orthographic.camera = {.projection = Projection::orthographic, .ymag = 1.3f, .zfar = 100.0f};
    ToonScene far_away = scene_with({sun, side});
    far_away.radius = 0.3;
    return {{"default", scene_with({sun}), Toon{}},
            {"two tones, light ends at 90 degrees", scene_with({sun}), Toon{.bands = 2, .wrap = 0.0f}},
            {"two lights", scene_with({sun, side}),
             Toon{.bands = 4, .wrap = 0.2f, .dark_edge = 0.55f, .light_edge = 0.95f}},
            {"soft, orthographic", orthographic, Toon{.bands = 3, .softness = 0.2f}},
            {"one tone", scene_with({sun}), Toon{.bands = 1, .light = {0.9f, 0.8f, 0.7f}}},
            {"lamp and spot", scene_with({lamp, spot}), Toon{.bands = 5, .light = {1, 0.9f, 0.8f}}},
            {"tones thinner than pixels", far_away, Toon{.bands = 16, .dark_edge = 0.5f, .light_edge = 1.0f}},
            {"soft tones thinner than pixels", far_away,
             Toon{.bands = 16, .dark_edge = 0.5f, .light_edge = 1.0f, .softness = 0.05f}}};
}

using ToonTest = GlTest;

TEST_P(ToonTest, BandsMatchTheClosedForm) {
    for (const Trial& trial : band_trials()) {
        const Difference found = compare(context(), trial);
        EXPECT_LE(found.worst, 1.0 / 255.0) << trial.name << " at " << found.where;
        EXPECT_GT(found.drawn, trial.scene.radius < 1.0 ? 400 : 5500) << trial.name;
        RecordProperty(trial.name, fmt::format("{:.2e}", found.worst));
    }
}

TEST_P(ToonTest, RimsAndHighlightsMatchTheClosedForm) {
    const ToonLight sun = light_from({1.0f, 0.5f, -0.1f}), side = light_from({-0.3f, 0.8f, 0.9f}, glm::vec3(1), 0.9f);
    const Toon rim{.rim = 0.7f, .rim_width = 0.4f, .rim_color = {1, 0.9f, 0.7f}};
    Toon all_round = rim;
    all_round.rim_lit_only = false;
    const Toon shine{.specular = 0.8f, .specular_size = 0.2f, .specular_color = {1, 1, 0.9f}};
    Toon speck = shine;
    speck.specular_size = 0.004f;
    for (const Trial& trial :
         {Trial{"rim", scene_with({sun}), rim}, Trial{"rim all round", scene_with({sun}), all_round},
          Trial{"highlight", scene_with({sun}), shine},
          Trial{"two highlights that run together", scene_with({sun, side}), shine},
          Trial{"a highlight below a pixel", scene_with({sun}), speck}}) {
        const Difference found = compare(context(), trial);
        // The highlight of a speck falls by its size in a pixel: normals of faces are not exact enough for more.
        EXPECT_LE(found.worst, trial.toon.specular_size < 0.01f ? 0.05 : 2.0 / 255.0)
            << trial.name << " at " << found.where;
        RecordProperty(trial.name, fmt::format("{:.2e}", found.worst));
    }
}

TEST_P(ToonTest, DetailFollowsItsAttributeInBandsAndRamps) {
    const TempFolder folder;
    const assets::Image noise = noise_ramp(7, 5);
    assets::write_png(folder / "noise.png", noise);
    const ToonScene scene = scene_with({light_from({1.0f, 0.5f, -0.1f})});
    for (const ToonDetail detail : {ToonDetail::none, ToonDetail::depth, ToonDetail::depth_of_field, ToonDetail::focus,
                                    ToonDetail::orientation, ToonDetail::highlight}) {
        Toon toon{.bands = 4, .detail = detail, .detail_distance = 2.65f, .detail_ratio = 1.4f};
        if (detail == ToonDetail::focus) toon.detail_distance = 0.5f, toon.detail_ratio = 4.0f;
        toon.focus_point = glm::vec3(0.6f, 0.3f, 0.7f);
        if (detail == ToonDetail::orientation) toon.detail_power = 0.5f;
        Toon from_file = toon;
        from_file.ramp = (folder / "noise.png").string();
        from_file.ramp_use = detail == ToonDetail::depth ? RampUse::multiply : RampUse::replace;
        const Difference bands = compare(context(), {"bands", scene, toon});
        EXPECT_LE(bands.worst, 1.0 / 255.0) << int(detail) << " at " << bands.where;
        const Difference ramp = compare(context(), {"ramp", scene, from_file, noise});
        EXPECT_LE(ramp.worst, 2.0 / 255.0) << int(detail) << " at " << ramp.where;
        RecordProperty("detail " + std::to_string(int(detail)), fmt::format("{:.2e} {:.2e}", bands.worst, ramp.worst));
    }
}

/// The mean over each pixel's square of the bands as they are, unfiltered: what filtering stands for.
TEST_P(ToonTest, EdgesAreAntiAliased) {
    constexpr int grid = 12;
    for (const int bands : {2, 16}) {
        Trial trial{"", scene_with({light_from({1.0f, 0.5f, -0.6f})}), Toon{.bands = bands}};
        if (bands == 16) trial.scene.radius = 0.12; // a dozen tones over some ten pixels
        const assets::Image color = draw_color(context(), trial.scene, trial.toon);
        const Expected expected(trial);
        double ours = 0.0, unfiltered = 0.0;
        const auto exact = [&](double x, double y) {
            const ToonPoint at = trial.scene.cast(x, y);
            return banded(trial.toon, trial.scene.tone(at, trial.toon.wrap), 1e-9, 1.0) * trial.scene.color;
        };
        for (int row = 0; row < canvas.height; ++row)
            for (int column = 0; column < canvas.width; ++column) {
                if (!expected.point(column, row).hit || !expected.away_from_outlines(column, row)) continue;
                dvec3 mean(0.0);
                for (int i = 0; i < grid * grid; ++i)
                    mean += exact(column + (i % grid + 0.5) / grid, row + (i / grid + 0.5) / grid);
                mean /= grid * grid;
                const float* pixel = color.f32() + 3 * (row * canvas.width + column);
                ours += std::pow(glm::distance(dvec3(pixel[0], pixel[1], pixel[2]), mean), 2.0);
                unfiltered += std::pow(glm::distance(exact(column + 0.5, row + 0.5), mean), 2.0);
            }
        EXPECT_LT(std::sqrt(ours), std::sqrt(unfiltered) / 5.0) << bands;
        RecordProperty(std::to_string(bands) + " bands", fmt::format("{:.3f}", std::sqrt(ours / unfiltered)));
    }
}

/// Colours that many pixels have, as 8-bit triples.
std::set<std::vector<int>> flat_colors(const assets::Image& color) {
    std::map<std::vector<int>, int> counts;
    for (int i = 0; i < color.width * color.height; ++i) {
        std::vector<int> key;
        for (int c = 0; c < 3; ++c) key.push_back(static_cast<int>(std::lround(255.0f * color.f32()[3 * i + c])));
        ++counts[key];
    }
    std::set<std::vector<int>> result;
    for (const auto& [key, count] : counts)
        if (count > 60) result.insert(key);
    return result;
}

TEST_P(ToonTest, OverlappingLightsAddNoBand) {
    const ToonLight left = light_from({-0.6f, 0.5f, 0.8f}), right = light_from({1.1f, 0.5f, 0.5f}, glm::vec3(1), 0.7f);
    const Toon toon{.bands = 3, .wrap = 0.0f};
    const auto one = flat_colors(draw_color(context(), scene_with({left}), toon));
    const auto two = flat_colors(draw_color(context(), scene_with({left, right}), toon));
    EXPECT_EQ(one.size(), 4u) << "three tones and the background";
    EXPECT_GE(two.size(), 3u);
    for (const std::vector<int>& color : two) EXPECT_TRUE(one.contains(color));
    // So the test can fail: what cutting each light by itself would give.
    assets::Image each = draw_color(context(), scene_with({left}), toon);
    const assets::Image other = draw_color(context(), scene_with({right}), toon);
    for (int i = 0; i < 3 * each.width * each.height; ++i) each.f32()[i] = 0.5f * (each.f32()[i] + other.f32()[i]);
    const auto steps = flat_colors(each);
    EXPECT_TRUE(std::ranges::any_of(steps, [&](const std::vector<int>& color) { return !one.contains(color); }));
}

/// A step half as large changes no pixel by more than half as much: edges move, and nothing jumps.
TEST_P(ToonTest, NothingPops) {
    const Toon toon{.bands = 4,
                    .detail = ToonDetail::depth,
                    .detail_distance = 2.0f,
                    .detail_ratio = 3.0f,
                    .rim = 0.5f,
                    .specular = 0.7f};
    const ToonScene still = scene_with({light_from({0, 0, 1})});
    const Trial outline{"", still, toon};
    const Expected inside(outline);
    DrawnScene drawn(context(), canvas);
    drawn.renderer().request_aov("color");
    SurfaceMaterial material;
    material.base_color = glm::vec4(0.8f, 0.5f, 0.3f, 1.0f);
    drawn.world().add(drawn.add(surface_mesh(geometry::icosphere(1.0, 6), material)), toon);
    const Entity camera = drawn.add(still.camera, still.eye);
    const Entity sun = drawn.world().create_with(Transform{}, Light{});
    const auto draw_at = [&](float turned, float moved) {
        drawn.world().get_mutable<Transform>(sun) =
            light_from({1.2f + std::sin(turned), 0.6f, 0.2f * std::cos(turned)}).place;
        drawn.world().get_mutable<Transform>(camera).translation =
            still.eye.translation + moved * glm::vec3(0.3f, 0.1f, 0.5f);
        drawn.renderer().render_frame();
        return drawn.renderer().read_aov("color");
    };
    const auto largest = [&](float step) {
        double most = 0.0;
        for (int at = 0; at < 3; ++at) {
            const float turned = 0.9f * float(at);
            const assets::Image before = draw_at(turned, 0.0f), after = draw_at(turned + step, step);
            for (int i = 0; i < canvas.width * canvas.height; ++i) {
                if (!inside.away_from_outlines(i % canvas.width, i / canvas.width)) continue;
                for (int c = 0; c < 3; ++c)
                    most = std::max(most, double(std::abs(before.f32()[3 * i + c] - after.f32()[3 * i + c])));
            }
        }
        return most;
    };
    const double whole = largest(0.004f), half = largest(0.002f), quarter = largest(0.001f);
    EXPECT_GT(quarter, 0.002) << "too small a step to tell";
    EXPECT_LT(half, 0.65 * whole);
    EXPECT_LT(quarter, 0.65 * half);
}

HACHURE_INSTANTIATE_GL_TESTS_ONCE(ToonTest);

} // namespace
} // namespace hachure::test
