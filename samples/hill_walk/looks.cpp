#include "looks.h"

#include <array>

namespace hill_walk {
namespace {

using namespace hachure;

Toon tones(glm::vec3 light, glm::vec3 shade, float softness = 0.8f) {
    return {.bands = 5,
            .dark_edge = 0.05f,
            .light_edge = 0.95f,
            .softness = softness,
            .light = light,
            .shade = shade,
            .ramp_use = RampUse::replace};
}

/// Of ink: full weight as soon as there is a line.
ImplicitBrush contours(glm::vec3 color, float size) {
    return {.feature = BrushFeature::contours,
            .order = 2,
            .diffusion = 0,
            .window = 4.0f,
            .spread = 1.0f,
            .size = size,
            .color = color,
            .contrast = 250.0f};
}

ImplicitBrush folds(BrushFeature feature, glm::vec3 color, float size) {
    return {.feature = feature,
            .order = 1,
            .diffusion = 8,
            .window = 7.0f,
            .peak_low = 0.15f,
            .peak_high = 0.4f,
            .size = size,
            .weak_size = 0.3f * size,
            .size_by = BrushDriver::height,
            .size_low = 0.15f,
            .size_high = 1.0f,
            .color = color,
            .contrast = 200.0f};
}

/// Figure 12: valleys are washes of blue, ridges dry strokes of brown, contours ink.
Look washed_ground() {
    ImplicitBrush valleys{.feature = BrushFeature::valleys,
                          .diffusion = 16,
                          .window = 8.0f,
                          .peak_low = 0.06f,
                          .peak_high = 0.4f,
                          .spread = 3.0f,
                          .tip = BrushTip::soft_disk,
                          .size = 6.0f,
                          .color = {0.03f, 0.12f, 0.3f},
                          .contrast = 8.0f,
                          .canvas = 0.5f,
                          .grain_size = 7.0f};
    ImplicitBrush ridges{.feature = BrushFeature::ridges,
                         .order = 1,
                         .diffusion = 16,
                         .window = 8.0f,
                         .peak_low = 0.1f,
                         .peak_high = 0.4f,
                         .spread = 0.6f,
                         .tip = BrushTip::bristle,
                         .size = 6.0f,
                         .turn = BrushTurn::along,
                         .color = {0.4f, 0.12f, 0.02f},
                         .contrast = 150.0f,
                         .interruption = 0.2f,
                         .grain_size = 30.0f};
    return {"washes", tones({0.98f, 0.95f, 0.86f}, {0.72f, 0.71f, 0.6f}), {valleys, ridges, contours({}, 1.4f)}};
}

/// Light ridges and deep valleys on grey ground.
Look moonlit_ground() {
    ImplicitBrush ridges = folds(BrushFeature::ridges, {0.95f, 0.97f, 1.0f}, 3.0f);
    ridges.diffusion = 16;
    ridges.canvas = 0.5f;
    ridges.grain_size = 5.0f;
    ImplicitBrush valleys = folds(BrushFeature::valleys, {0.0f, 0.0f, 0.02f}, 4.0f);
    valleys.diffusion = 16;
    return {"moonlit", tones({0.3f, 0.36f, 0.45f}, {0.05f, 0.07f, 0.12f}), {valleys, ridges, contours({}, 1.6f)}};
}

/// Black ink, with a pen that swells.
Look inked_figure() {
    return {"ink",
            tones({1.0f, 0.98f, 0.94f}, {0.8f, 0.78f, 0.75f}, 0.0f),
            {folds(BrushFeature::valleys, {}, 2.0f), contours({}, 1.8f)}};
}

/// Red chalk, broad and rough.
Look chalked_figure() {
    constexpr glm::vec3 red{0.45f, 0.06f, 0.03f};
    ImplicitBrush outline = contours(red, 3.5f);
    outline.canvas = 0.7f;
    outline.size_noise = 0.5f;
    outline.grain_size = 5.0f;
    ImplicitBrush valleys = folds(BrushFeature::valleys, red, 3.0f);
    valleys.canvas = 0.7f;
    valleys.grain_size = 5.0f;
    return {"red chalk", tones({0.96f, 0.8f, 0.68f}, {0.75f, 0.5f, 0.4f}), {valleys, outline}};
}

/// A quick brush that trembles, and light along ridges.
Look sketched_figure() {
    ImplicitBrush outline = contours({0.02f, 0.03f, 0.2f}, 1.5f);
    outline.wobble = 1.8f;
    outline.grain_size = 22.0f;
    return {"sketch",
            tones({0.7f, 0.82f, 0.95f}, {0.4f, 0.55f, 0.75f}, 0.3f),
            {folds(BrushFeature::ridges, {1.0f, 1.0f, 1.0f}, 2.0f), outline}};
}

} // namespace

std::span<const Look> ground_looks() {
    static const std::array looks{washed_ground(), moonlit_ground()};
    return looks;
}

std::span<const Look> figure_looks() {
    static const std::array looks{inked_figure(), chalked_figure(), sketched_figure()};
    return looks;
}

} // namespace hill_walk
