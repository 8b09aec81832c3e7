#pragma once

#include <hachure/runtime/geometry/trace_ridges.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace hachure::geometry {

/// What a pixel that draws a line says of it.
struct ClaimedMiddle {
    glm::vec2 place{0.0f};   ///< the line's middle, pixels from the picture's lower left corner
    glm::vec2 tangent{0.0f}; ///< unit vector along the line, of either sign
    float width = 0.0f;      ///< of the line, pixels
    float away = 0.0f;       ///< from the pixel to the middle, pixels
    float opacity = 0.0f;    ///< along the line, 0 to 1
    std::uint32_t owner = 0;
    std::uint32_t pixel = 0; ///< index of the pixel
};

/// The middles of lines that the pixels of a picture claim, by where they are. Pixels draw what they claim: between the
/// middles of neighbours, where those are no farther apart than `longest_link`, they show a line.
class ClaimedMiddles {
public:
    static constexpr float longest_link = 1.5f; ///< pixels; the diagonal of one and a little

    /// Of the pixels that are seen to draw a line of this sign (TraceRidgesJob). Keeps its memory from call to call.
    void fill(const RidgeImage& image, float sign);

    [[nodiscard]] std::span<const ClaimedMiddle> claims() const { return claims_; }

    /// visit(index) for claims within `reach` pixels of a place, and some that are a little farther.
    template <class Visit> void each_near(glm::vec2 place, float reach, Visit&& visit) const {
        const glm::ivec2 low = glm::max(glm::ivec2(glm::floor(place - reach)), glm::ivec2(0));
        const glm::ivec2 high = glm::min(glm::ivec2(glm::floor(place + reach)), glm::ivec2(width_, height_) - 1);
        for (int y = low.y; y <= high.y; ++y)
            for (int x = low.x; x <= high.x; ++x)
                for (std::uint32_t i = starts_[index_of(x, y)]; i < starts_[index_of(x, y) + 1]; ++i) visit(i);
    }

    /// The place nearest to this one where pixels show a line of that owner, if there is one within `reach` pixels.
    [[nodiscard]] std::optional<glm::vec2> nearest(glm::vec2 place, std::uint32_t owner, float reach) const;

private:
    [[nodiscard]] std::size_t index_of(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
    }
    [[nodiscard]] std::uint32_t cell_of(glm::vec2 place) const;

    int width_ = 0, height_ = 0;
    std::vector<ClaimedMiddle> claims_;     ///< cell by cell of a pixel each
    std::vector<ClaimedMiddle> found_;      ///< scratch: pixel by pixel
    std::vector<std::uint32_t> starts_;     ///< of cells in `claims_`
    std::vector<std::uint32_t> claim_of_{}; ///< by pixel
};

} // namespace hachure::geometry
