#pragma once

#include <hachure/components/implicit_brush.h>
#include <hachure/runtime/scene/view.h>
#include <hachure/systems/implicit_brush/brush_noise_key.h>
#include <hachure/systems/implicit_brush/feature_key.h>

#include <glm/vec4.hpp>

#include <optional>

namespace hachure {

/// What the shader that makes stamps knows of a brush; as BrushStyle of shaders/implicit_brush/brush_style.glsl.
/// Lengths are in pixels, or in metres where `scale.y` is 1.
struct BrushStyle {
    glm::vec4 peak{0.0f};       ///< at the lower limit, at the upper limit; the limits
    glm::vec4 spread{0.0f};     ///< likewise
    glm::vec4 size{0.0f};       ///< likewise
    glm::vec4 color{0.0f};      ///< w: how much noise changes it
    glm::vec4 weak_color{0.0f}; ///< w: angle, radians
    glm::vec4 tint{0.0f};       ///< 0 and 1; limits of what colour follows
    glm::vec4 drivers{0.0f};    ///< BrushDriver of peak, spread, size, colour
    glm::vec4 choices{0.0f};    ///< BrushTurn, BrushColor; shift along and across, radii
    glm::vec4 noise{0.0f};      ///< interruption, wobble (radii), turn (radians), size
    glm::vec4 scale{0.0f};      ///< cutoff; 1 where lengths are in metres; largest radius, px

    friend bool operator==(const BrushStyle&, const BrushStyle&) = default;
};

/// Stamps are at most this large, px.
inline constexpr float largest_stamp = 64.0f;
/// Weights fall off at least this wide, px of standard deviation: sums over pixels of a narrower Gaussian would depend
/// on where between them the line lies (by 1.4 % here).
inline constexpr float least_spread = 0.5f;

[[nodiscard]] BrushStyle brush_style(const ImplicitBrush& brush, const View& view);

/// Whether any ink can come of it.
[[nodiscard]] bool draws_anything(const ImplicitBrush& brush);

/// The largest radius of a stamp, px, where a metre is at most `metre` pixels.
[[nodiscard]] float largest_radius(const ImplicitBrush& brush, const View& view, float metre);

/// How far stamps are moved from their pixels at most, in radii of the stamp.
[[nodiscard]] float largest_shift(const ImplicitBrush& brush);

/// How far from a line pixels count, px, likewise.
[[nodiscard]] float weight_reach(const ImplicitBrush& brush, const View& view, float metre);

/// How far from a line there can be ink, px, likewise.
[[nodiscard]] float ink_reach(const ImplicitBrush& brush, const View& view, float metre);

[[nodiscard]] FeatureKey feature_key(const ImplicitBrush& brush, const View& view);

/// The noise that it wants; none where nothing of it is noisy.
[[nodiscard]] std::optional<BrushNoiseKey> noise_key(const ImplicitBrush& brush, const View& view);

/// The height below which a feature leaves no ink; 0 where all do.
[[nodiscard]] float least_height(const ImplicitBrush& brush);

} // namespace hachure
