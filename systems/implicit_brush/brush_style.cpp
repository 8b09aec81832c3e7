#include <hachure/systems/implicit_brush/brush_style.h>

#include <algorithm>
#include <cmath>

namespace hachure {
namespace {

/// Pixels of a length of 1, or 1 for metres.
float unit_of(const ImplicitBrush& brush, const View& view) {
    return brush.unit == BrushUnit::picture ? 0.001f * static_cast<float>(view.height) : 1.0f;
}

float pixels_of(float length, const ImplicitBrush& brush, const View& view, float metre) {
    return length * (brush.unit == BrushUnit::world ? metre : unit_of(brush, view));
}

/// From `weak` at `low` to `strong` at `high`; the limits are never the same.
glm::vec4 driven(float weak, float strong, float low, float high) {
    return {weak, strong, low, std::max(high, low + 1e-6f)};
}

float choice(auto value) { return static_cast<float>(static_cast<int>(value)); }

float largest(BrushDriver by, float weak, float strong) {
    return by == BrushDriver::constant ? strong : std::max(weak, strong);
}

bool follows_relief(BrushFeature feature) {
    return feature == BrushFeature::ridges || feature == BrushFeature::valleys || feature == BrushFeature::inflections;
}

} // namespace

BrushStyle brush_style(const ImplicitBrush& brush, const View& view) {
    const float unit = unit_of(brush, view);
    const bool constant_peak = brush.peak_by == BrushDriver::constant;
    return {.peak = driven(constant_peak ? brush.peak : 0.0f, brush.peak, brush.peak_low, brush.peak_high),
            .spread = driven(brush.weak_spread * unit, brush.spread * unit, brush.spread_low, brush.spread_high),
            .size = driven(brush.weak_size * unit, brush.size * unit, brush.size_low, brush.size_high),
            .color = glm::vec4(brush.color, brush.color_noise),
            .weak_color = glm::vec4(brush.weak_color, brush.angle),
            .tint = driven(0.0f, 1.0f, brush.color_low, brush.color_high),
            .drivers = {choice(brush.peak_by), choice(brush.spread_by), choice(brush.size_by), choice(brush.color_by)},
            .choices = {choice(brush.turn), choice(brush.coloring), brush.shift_along, brush.shift_across},
            .noise = {brush.interruption, brush.wobble, brush.turn_noise, brush.size_noise},
            .scale = {brush.cutoff, brush.unit == BrushUnit::world ? 1.0f : 0.0f, largest_stamp, 0.0f}};
}

bool draws_anything(const ImplicitBrush& brush) {
    return brush.visible && brush.peak > 0.0f && brush.opacity > 0.0f &&
           largest(brush.size_by, brush.weak_size, brush.size) > 0.0f;
}

float largest_radius(const ImplicitBrush& brush, const View& view, float metre) {
    return std::min(largest_stamp, pixels_of(largest(brush.size_by, brush.weak_size, brush.size), brush, view, metre));
}

float weight_reach(const ImplicitBrush& brush, const View& view, float metre) {
    const float spread = std::max(
        least_spread, pixels_of(largest(brush.spread_by, brush.weak_spread, brush.spread), brush, view, metre));
    // Where a Gaussian has fallen to the cut-off, of a weight of 1.
    const float counts = spread * std::sqrt(-2.0f * std::log(std::clamp(brush.cutoff, 1e-4f, 0.5f)));
    return std::min(counts, std::min(largest_stamp, pixels_of(brush.window, brush, view, metre)));
}

float largest_shift(const ImplicitBrush& brush) {
    // Noise moves along both axes of the picture.
    return std::abs(brush.shift_along) + std::abs(brush.shift_across) + std::sqrt(2.0f) * brush.wobble;
}

float ink_reach(const ImplicitBrush& brush, const View& view, float metre) {
    // The corner of a square stamp is farthest.
    const float stamp = (std::sqrt(2.0f) + largest_shift(brush)) * largest_radius(brush, view, metre);
    return weight_reach(brush, view, metre) + stamp;
}

FeatureKey feature_key(const ImplicitBrush& brush, const View& view) {
    FeatureKey key{.feature = brush.feature,
                   .source = BrushSource::surface,
                   .diffusion = brush.diffusion,
                   .window = brush.window * unit_of(brush, view),
                   .world_window = brush.unit == BrushUnit::world};
    if (brush.feature == BrushFeature::luminance_edges) key.source = BrushSource::luminance;
    if (follows_relief(brush.feature)) key.source = brush.source;
    if (!key.world_window) key.window = std::min(key.window, largest_stamp);
    return key;
}

std::optional<BrushNoiseKey> noise_key(const ImplicitBrush& brush, const View& view) {
    const bool noisy = brush.canvas > 0.0f || brush.interruption > 0.0f || brush.wobble > 0.0f ||
                       brush.turn_noise > 0.0f || brush.size_noise > 0.0f || brush.color_noise > 0.0f;
    if (!noisy) return {};
    return BrushNoiseKey{.grain = brush.grain,
                         .size = brush.grain_size * unit_of(brush, view),
                         .world_size = brush.unit == BrushUnit::world,
                         .flatness = brush.flatness,
                         .seed = static_cast<std::uint32_t>(brush.seed)};
}

float least_height(const ImplicitBrush& brush) { return brush.peak_by == BrushDriver::height ? brush.peak_low : 0.0f; }

} // namespace hachure
