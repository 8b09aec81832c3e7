#include "checks.h"

#include <hachure/samples/common/sample_window.h>
#include <hachure/systems/shade_strokes/shade_counts.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace sun_walk {

using namespace hachure;

Checks::Checks(World& world, Renderer& renderer, Day& day) : world_(world), renderer_(renderer), day_(day) {
    for (const char* aov : {"shade_needed", "shade_delivered", "stroke_coverage"}) renderer_.request_aov(aov);
}

void Checks::check(bool holds, const char* what) {
    if (!holds) std::fprintf(stderr, "sun_walk: %s\n", what);
    hold_ = hold_ && holds;
}

void Checks::draw(double seconds) { renderer_.render_frame(seconds); }

double Checks::mean(const char* aov) {
    const assets::Image image = renderer_.read_aov(aov);
    double sum = 0.0;
    for (int i = 0; i < image.width * image.height; ++i) sum += double(image.f32()[i]);
    return sum / (image.width * image.height);
}

void Checks::strokes_follow(int frames) {
    draw();
    const ShadeCounts& counts = world_.resource<ShadeCounts>();
    std::uint64_t touched = 0;
    for (int i = 0; i < frames; ++i) {
        draw(1.0 / 30.0);
        std::printf("frame %d: %llu triangles touched, %llu chains, %llu of them new\n", i,
                    static_cast<unsigned long long>(counts.triangles_touched),
                    static_cast<unsigned long long>(counts.chains), static_cast<unsigned long long>(counts.begun));
        touched += counts.triangles_touched;
        check(counts.begun < counts.chains / 10, "strokes are drawn anew instead of changed");
    }
    check(touched > 0, "strokes do not follow the light");
}

void Checks::shade_is_delivered() {
    for (const double at : {0.3, 1.2, 2.0, 2.9}) {
        day_.place_sun(at);
        draw();
        const assets::Image needed = renderer_.read_aov("shade_needed"),
                            delivered = renderer_.read_aov("shade_delivered");
        double sum = 0.0;
        int shaded = 0;
        for (int i = 0; i < needed.width * needed.height; ++i) {
            if (needed.f32()[i] <= 0.0f && delivered.f32()[i] <= 0.0f) continue;
            sum += std::abs(double(needed.f32()[i]) - double(delivered.f32()[i]));
            ++shaded;
        }
        const double off = sum / std::max(1, shaded);
        std::printf("sun at %.1f: shade is %.4f off on %d pixels\n", at, off, shaded);
        check(shaded > 100, "nothing is shaded");
        check(off <= double(ShadeStrokes{}.dead_band), "strokes deliver another shade than is needed");
    }
}

void Checks::night_is_dark() {
    day_.place_sun(1.57);
    draw();
    const double noon = mean("stroke_coverage");
    day_.place_sun(4.71);
    draw();
    const double night = mean("stroke_coverage");
    std::printf("strokes cover %.4f of the picture at noon, %.4f at midnight\n", noon, night);
    check(noon > 0.0, "there are no strokes at noon");
    check(night > 1.5 * noon, "night is not darker than day");
    day_.place_sun(1.0);
}

void Checks::turning_costs_nothing(samples::Orbit& orbit) {
    draw();
    orbit.turn(0.2f, 0.0f);
    draw();
    const ShadeCounts& counts = world_.resource<ShadeCounts>();
    std::printf("camera turned: %llu triangles looked at\n", static_cast<unsigned long long>(counts.triangles_swept));
    check(counts.triangles_swept == 0, "a camera that turns has triangles looked at");
}

void Checks::nothing_moves() {
    draw(1.0 / 30.0);
    draw(1.0 / 30.0);
    std::printf("nothing moved: %d passes ran\n", samples::passes_run(renderer_));
    check(samples::passes_run(renderer_) == 0, "passes run while nothing moves");
}

} // namespace sun_walk
