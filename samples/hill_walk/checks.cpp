#include "checks.h"

#include <hachure/samples/common/sample_window.h>

#include <glm/glm.hpp>

#include <array>
#include <cmath>
#include <cstdio>
#include <utility>

namespace hill_walk {

using namespace hachure;

namespace {

glm::dvec3 pixel(const assets::Image& image, int x, int y) {
    const float* p = image.f32() + (y * image.width + x) * image.channels;
    return {p[0], p[1], p[2]};
}

/// The sum over all pixels of how far two pictures differ.
double difference(const assets::Image& a, const assets::Image& b) {
    double sum = 0.0;
    for (int y = 0; y < a.height; ++y)
        for (int x = 0; x < a.width; ++x) sum += glm::length(pixel(a, x, y) - pixel(b, x, y));
    return sum;
}

/// The colour of pixels that ink covers, weighed by how much it changes them.
glm::dvec3 ink_color(const assets::Image& inked, const assets::Image& plain) {
    glm::dvec3 sum(0.0);
    double weight = 1e-9;
    for (int y = 0; y < inked.height; ++y)
        for (int x = 0; x < inked.width; ++x) {
            const double w = glm::length(pixel(inked, x, y) - pixel(plain, x, y));
            sum += w * pixel(inked, x, y);
            weight += w;
        }
    return sum / weight;
}

} // namespace

Checks::Checks(World& world, Renderer& renderer, HillWalk& scene) : world_(world), renderer_(renderer), scene_(scene) {
    renderer_.request_aov("color");
}

void Checks::check(bool holds, const char* what) {
    if (!holds) std::fprintf(stderr, "hill_walk: %s\n", what);
    hold_ = hold_ && holds;
}

assets::Image Checks::draw(double seconds) {
    renderer_.render_frame(seconds);
    return renderer_.read_aov("color");
}

template <class F> assets::Image Checks::draw_only(F shown) {
    for (std::size_t part = 0; part < HillWalk::part_count; ++part)
        for (const Entity entity : scene_.brushes(HillWalk::Part(part))) {
            ImplicitBrush& brush = world_.get_mutable<ImplicitBrush>(entity);
            brush.visible = shown(HillWalk::Part(part), std::as_const(brush));
        }
    return draw();
}

void Checks::figures_move(int frames) {
    assets::Image before = draw();
    for (int i = 0; i < frames; ++i) {
        assets::Image now = draw(1.0 / 30.0);
        const double changed = difference(now, before);
        std::printf("frame %d: %.0f px other than before\n", i, changed);
        check(changed > 20.0, "figures do not move");
        before = std::move(now);
    }
}

void Checks::brushes_are_their_own() {
    const assets::Image plain = draw_only([](auto, auto&) { return false; });
    std::array<glm::dvec3, HillWalk::part_count> colors;
    for (std::size_t part = 0; part < colors.size(); ++part) {
        const assets::Image inked = draw_only([&](HillWalk::Part p, auto&) { return p == HillWalk::Part(part); });
        colors[part] = ink_color(inked, plain);
        const double ink = difference(inked, plain);
        std::printf("%s: %.0f px of ink of colour %.2f %.2f %.2f\n", scene_.look_of(HillWalk::Part(part)).c_str(), ink,
                    colors[part].r, colors[part].g, colors[part].b);
        check(ink > 30.0, "a part has no lines");
        for (std::size_t other = 0; other < part; ++other)
            check(glm::length(colors[part] - colors[other]) > 0.04, "two parts have ink of one colour");
    }
}

void Checks::features_share_a_frame() {
    const assets::Image all = draw_only([](auto, auto&) { return true; });
    for (const auto& [feature, name] : {std::pair{BrushFeature::contours, "contours"},
                                        {BrushFeature::ridges, "ridges"},
                                        {BrushFeature::valleys, "valleys"}}) {
        const assets::Image others =
            draw_only([&](auto, const ImplicitBrush& brush) { return brush.feature != feature; });
        std::printf("without %s: %.0f px other\n", name, difference(all, others));
        check(difference(all, others) > 30.0, "a feature is missing");
    }
    static_cast<void>(draw_only([](auto, auto&) { return true; }));
}

void Checks::nothing_moves() {
    static_cast<void>(draw(1.0 / 30.0));
    static_cast<void>(draw(1.0 / 30.0));
    std::printf("nothing moved: %d passes ran\n", samples::passes_run(renderer_));
    check(samples::passes_run(renderer_) == 0, "passes run while nothing moves");
}

double Checks::drift(BrushGrain grain, samples::Orbit& orbit) {
    for (const Entity entity : scene_.brushes(HillWalk::ground)) {
        ImplicitBrush& brush = world_.get_mutable<ImplicitBrush>(entity);
        brush.grain = grain;
        brush.canvas = 1.0f;
    }
    const assets::Image before = draw();
    orbit.turn(0.012f, 0.0f);
    const assets::Image now = draw();
    const assets::Image velocity = renderer_.read_aov("velocity"); // pixels right and up; rows go down
    orbit.turn(-0.012f, 0.0f);
    double sum = 0.0;
    for (int y = 0; y < now.height; ++y)
        for (int x = 0; x < now.width; ++x) {
            const float* v = velocity.f32() + (y * now.width + x) * velocity.channels;
            const int from_x = static_cast<int>(std::lround(float(x) - v[0]));
            const int from_y = static_cast<int>(std::lround(float(y) + v[1]));
            if (from_x < 0 || from_y < 0 || from_x >= now.width || from_y >= now.height) continue;
            sum += glm::length(pixel(now, x, y) - pixel(before, from_x, from_y));
        }
    return sum / (now.width * now.height);
}

void Checks::noise_holds_to_the_ground(samples::Orbit& orbit) {
    renderer_.request_aov("velocity");
    static_cast<void>(draw());
    const double solid = drift(BrushGrain::solid, orbit), screen = drift(BrushGrain::screen, orbit);
    std::printf("along its motion the ground changes by %.4f with noise of its own, %.4f with the screen's\n", solid,
                screen);
    check(solid < 0.9 * screen, "noise does not hold to the surface");
}

} // namespace hill_walk
