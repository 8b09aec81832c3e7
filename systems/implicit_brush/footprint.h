#pragma once

#include <hachure/components/implicit_brush.h>
#include <hachure/runtime/gpu/shader_source.h>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <array>
#include <vector>

namespace hachure {

// The forms that brushes stamp, b(u) of section 4.1: opacity by place u in the tip's own frame, where it reaches from
// -1 to 1. A stamp turns that frame by its angle and makes it `radius` pixels large, `radius * aspect` pixels across.
// The rim is smoothed over about a pixel such that what a stamp adds to the picture is its area times its opacity,
// wherever between pixels it lies (shaders/implicit_brush/footprint.glsl).

/// Half the thickness of BrushTip::line, as a part of its half length.
inline constexpr float line_thickness = 0.15f;

/// The hairs of BrushTip::bristle, along x: middle of a hair x, y, half its length, half its thickness. They lie within
/// the unit circle, apart from each other.
inline constexpr std::array<glm::vec4, 7> bristle_hairs = {{{0.05f, -0.82f, 0.42f, 0.055f},
                                                            {-0.08f, -0.56f, 0.68f, 0.085f},
                                                            {0.04f, -0.27f, 0.86f, 0.060f},
                                                            {-0.02f, 0.02f, 0.93f, 0.095f},
                                                            {0.10f, 0.30f, 0.80f, 0.075f},
                                                            {-0.10f, 0.57f, 0.62f, 0.050f},
                                                            {0.06f, 0.81f, 0.40f, 0.070f}}};

/// The drops of BrushTip::splatter: middle x, y, radius. They lie within the unit circle, apart from each other.
inline constexpr std::array<glm::vec3, 9> splatter_drops = {{{-0.08f, 0.05f, 0.36f},
                                                             {0.52f, 0.31f, 0.17f},
                                                             {0.36f, -0.48f, 0.20f},
                                                             {-0.49f, -0.52f, 0.13f},
                                                             {-0.66f, 0.27f, 0.15f},
                                                             {0.05f, 0.71f, 0.14f},
                                                             {0.79f, -0.17f, 0.10f},
                                                             {-0.12f, -0.81f, 0.09f},
                                                             {-0.43f, 0.74f, 0.08f}}};

/// A form and its proportions.
struct Footprint {
    BrushTip tip = BrushTip::disk;
    float aspect = 1.0f;      ///< (0, 1]: height as a part of width
    float bitmap_mean = 0.0f; ///< of BrushTip::bitmap: its opacity on average, 0 to 1

    /// The integral of b over a stamp of that radius, px^2.
    [[nodiscard]] double mass(double radius) const;

    /// How far from its middle a stamp of that radius has ink, px; never too little.
    [[nodiscard]] double reach(double radius) const;

    /// The pixels of the smallest box around one; a measure of what it costs to draw.
    [[nodiscard]] double box_area(double radius) const;

    /// Whether turning changes nothing.
    [[nodiscard]] bool round() const;

    /// What footprint.glsl needs to know.
    [[nodiscard]] std::vector<gpu::ShaderDefine> defines() const;
};

} // namespace hachure
