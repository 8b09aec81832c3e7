#pragma once

#include <hachure/runtime/geometry/chain_segments.h>
#include <hachure/runtime/geometry/polylines.h>

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace hachure::geometry {

/// What every pixel of a picture knows of the ridge or valley nearest to it. Row by row, the bottom row first.
struct RidgeImage {
    int width = 0, height = 0; ///< pixels
    /// xy from the pixel's centre to the nearest place of its line, pixels, y up; z signed curvature, above 0 for
    /// valleys (dark lines), below for ridges, 0 for no line; w opacity there, 0 for no line.
    std::span<const glm::vec4> points;
    /// xy unit vector along the line, of either sign; z width of the line there, pixels; w tone there.
    std::span<const glm::vec4> directions;
    std::span<const std::uint32_t> owners; ///< whose line it is; 0 for nobody's
};

/// Where a line passes between two neighbouring pixels, or lines meet.
struct RidgeNode {
    LinePoint point;
    glm::vec2 tangent{0.0f}; ///< unit, of either sign; 0 where lines meet
    std::uint32_t owner = 0;
};

/// Finds the lines that ridges of one kind make, piece by piece, below the grid of pixels.
///
/// Steger (1998) links one point per pixel by distance and angle, which leaves to chance what a line does next to
/// itself. Here pixels on both sides of a line say how far away it is, so that it passes between two neighbours where
/// their signed distances change sign, as a contour does: each piece crosses one cell of four pixels, pieces of
/// neighbouring cells share an end, and no place is found twice. Where three or four places lie around a cell, lines
/// meet in it. A pixel that is the only one to see the line that passes through it makes a node without pieces.
struct TraceRidgesJob {
    RidgeImage image;
    float sign = 1.0f; ///< 1 for valleys, -1 for ridges

    std::vector<RidgeNode> nodes{};      ///< out, kept from run to run
    std::vector<SegmentEnds> segments{}; ///< out: two different nodes each, by index

    /// Asserts that sizes agree.
    void validate() const;
    void run();

    /// Scratch: nodes on the edges of the grid to the right of the pixels of a row and of the one above it, and above
    /// those of a row and of the one below it.
    std::vector<std::uint32_t> right[2]{}, above[2]{};

private:
    [[nodiscard]] bool holds_line(std::size_t pixel) const;
    [[nodiscard]] std::uint32_t cross(std::size_t pixel, std::size_t neighbour, glm::vec2 at, glm::vec2 step);
    [[nodiscard]] std::uint32_t cross_alone(std::size_t pixel, glm::vec2 at, glm::vec2 step);
    [[nodiscard]] std::uint32_t cross_link(std::size_t pixel, std::size_t neighbour, glm::vec2 at, glm::vec2 step);
    void cross_right(int y, std::vector<std::uint32_t>& row);
    void cross_above(int y, std::vector<std::uint32_t>& row);
    void join_cell(std::size_t x);
    void add_lone_pixels(int y);
};

} // namespace hachure::geometry
