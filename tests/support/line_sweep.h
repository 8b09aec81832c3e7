#pragma once

#include <hachure/tests/support/line_finding.h>
#include <hachure/tests/support/line_images.h>
#include <hachure/tests/support/line_score.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <vector>

namespace hachure::test {

/// A sweep: lines of one width, at many angles and phases.
struct LineSweep {
    double width = 4.0;
    double contrast = 1.0;
    double noise = 0.0;
    float beta = 0.2f;
    bool bright = false;
    ToneImage quality = {};
    int angles = 12;

    [[nodiscard]] int size() const { return 2 * static_cast<int>(4.0 * std::max(width, 3.0) + 10.0); }

    /// Draws `profile` at every angle and scores what is found.
    template <class Profile> LineScore score(RenderContext& render, const Profile& profile) const {
        AbstractedLines lines = plain_lines(width, contrast);
        lines.beta = beta;
        LineFinding finding(render, lines, quality, size(), size());
        LineScore score(width);
        for (int k = 0; k < angles; ++k) {
            // Of a few angles none along an axis, where pixels of a whole column can lie within a thousandth of a pixel
            // of the rim: one of 12 angles would decide.
            const double turn = angles < 64 ? 0.3 : 0.0;
            const auto line = TrueLine::through_middle(size(), size(), std::numbers::pi * (k + turn) / angles,
                                                       spread_phase(k + static_cast<int>(8.0 * width)));
            const double background = bright ? 0.5 - 0.5 * contrast : 0.5 + 0.5 * contrast;
            Tones tones = draw_line(size(), size(), line, profile, background, bright ? contrast : -contrast);
            add_noise(tones, noise, static_cast<std::uint64_t>(k));
            add(score, line, finding.find(tones));
        }
        return score;
    }

private:
    /// Pixels so near that they could be taken for the line's, and so far from the border that it does not matter.
    void add(LineScore& score, const TrueLine& line, const std::vector<PixelLine>& found) const {
        const double searched = std::max(width, 3.0);
        const int rim = static_cast<int>(3.0 * searched);
        for (int y = rim; y < size() - rim; ++y)
            for (int x = rim; x < size() - rim; ++x) {
                const double d = line.distance(pixel_center(x, y));
                if (std::abs(d) > 1.7 * searched) continue;
                const PixelLine& pixel = found[static_cast<std::size_t>(y * size() + x)];
                score.add(d, bright ? pixel.highlight : pixel.dark, -glm::dot(pixel.offset, line.normal));
                if (std::abs(d) < 0.5) score.add_curvature(std::abs(pixel.curvature));
            }
    }
};

} // namespace hachure::test
