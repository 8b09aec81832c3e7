#include <hachure/systems/implicit_brush/footprint.h>

#include <fmt/format.h>
#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

namespace hachure {
namespace {

/// The integral of b over the tip's own frame.
double unit_mass(const Footprint& footprint) {
    constexpr double pi = std::numbers::pi;
    double sum = 0.0;
    switch (footprint.tip) {
    case BrushTip::disk:
        return pi;
    case BrushTip::soft_disk:
        return pi / 3.0; // of (1 - r^2)^2
    case BrushTip::line:
        return 4.0 * double(line_thickness);
    case BrushTip::bristle:
        for (const glm::vec4& hair : bristle_hairs) sum += 4.0 * double(hair.z) * double(hair.w);
        return sum;
    case BrushTip::splatter:
        for (const glm::vec3& drop : splatter_drops) sum += pi * double(drop.z) * double(drop.z);
        return sum;
    case BrushTip::bitmap:
        return 4.0 * double(footprint.bitmap_mean);
    }
    return 0.0;
}

/// Half the sides of a box around a stamp, along and across its angle: as footprint_box() of the shader.
glm::dvec2 half_box(const Footprint& footprint, double radius) {
    const double aspect = double(footprint.aspect), across = radius * aspect;
    switch (footprint.tip) {
    case BrushTip::disk:
        return {std::max(radius, 1.0) + 1.0, std::max(across, 1.0) + 1.0};
    case BrushTip::soft_disk:
        return {std::max(radius, 2.0), std::max(across, 2.0)};
    case BrushTip::line:
        return {radius + 1.0, double(line_thickness) * across + 1.0};
    case BrushTip::splatter: // drops of less than 2 px are drawn as faint ones of 2 px
        return {radius + 3.0, across + 3.0};
    case BrushTip::bristle:
    case BrushTip::bitmap:
        break;
    }
    return {radius + 1.0, across + 1.0};
}

} // namespace

double Footprint::mass(double radius) const { return unit_mass(*this) * double(aspect) * radius * radius; }

double Footprint::reach(double radius) const {
    const glm::dvec2 box = half_box(*this, radius);
    switch (tip) {
    case BrushTip::disk:
    case BrushTip::soft_disk:
    case BrushTip::splatter: // within the unit circle
        return std::max(box.x, box.y);
    case BrushTip::bristle: // likewise, and smoothed along and across
        return radius + std::numbers::sqrt2;
    case BrushTip::line:
    case BrushTip::bitmap:
        break;
    }
    return std::hypot(box.x, box.y);
}

double Footprint::box_area(double radius) const {
    const glm::dvec2 box = half_box(*this, radius);
    return 4.0 * box.x * box.y;
}

bool Footprint::round() const { return aspect == 1.0f && (tip == BrushTip::disk || tip == BrushTip::soft_disk); }

std::vector<gpu::ShaderDefine> Footprint::defines() const {
    std::vector<gpu::ShaderDefine> defines = {{"TIP", std::to_string(static_cast<int>(tip))}};
    if (round()) defines.push_back({"ROUND", ""});
    std::string list;
    if (tip == BrushTip::line) defines.push_back({"LINE_THICKNESS", fmt::format("{:.9f}", line_thickness)});
    if (tip == BrushTip::bristle) {
        for (const glm::vec4& hair : bristle_hairs)
            list += fmt::format("{}vec4({:.9f}, {:.9f}, {:.9f}, {:.9f})", list.empty() ? "" : ", ", hair.x, hair.y,
                                hair.z, hair.w);
        defines.push_back({"HAIRS", list});
        defines.push_back({"HAIR_COUNT", std::to_string(bristle_hairs.size())});
    }
    if (tip == BrushTip::splatter) {
        for (const glm::vec3& drop : splatter_drops)
            list += fmt::format("{}vec3({:.9f}, {:.9f}, {:.9f})", list.empty() ? "" : ", ", drop.x, drop.y, drop.z);
        defines.push_back({"DROPS", list});
        defines.push_back({"DROP_COUNT", std::to_string(splatter_drops.size())});
    }
    return defines;
}

} // namespace hachure
