#include <hachure/runtime/geometry/claimed_middles.h>
#include <hachure/runtime/geometry/straight_piece.h>

#include <algorithm>
#include <cstddef>
#include <limits>

namespace hachure::geometry {
namespace {

constexpr std::uint32_t no_claim = std::numeric_limits<std::uint32_t>::max();

/// What is fainter is not seen.
constexpr float least_opacity = 0.03f;

/// Lines narrower than pixels are drawn by those that they pass through, pixels.
constexpr float least_reach = 0.6f;

/// How much a pixel draws of a line, whatever part of the width fades: over its outermost pixel a line may be faint.
float drawn_opacity(float opacity, float away, float width) {
    return opacity * std::clamp(std::max(0.5f * width, least_reach) - away, 0.0f, 1.0f);
}

} // namespace

/// Middles outside of the picture are in the cell at its rim.
std::uint32_t ClaimedMiddles::cell_of(glm::vec2 place) const {
    const glm::ivec2 at = glm::clamp(glm::ivec2(glm::floor(place)), glm::ivec2(0), glm::ivec2(width_, height_) - 1);
    return static_cast<std::uint32_t>(index_of(at.x, at.y));
}

void ClaimedMiddles::fill(const RidgeImage& image, float sign) {
    width_ = image.width;
    height_ = image.height;
    found_.clear();
    starts_.assign(image.points.size() + 1, 0);
    claim_of_.assign(image.points.size(), no_claim);
    for (std::size_t i = 0; i < image.points.size(); ++i) {
        const glm::vec4 &point = image.points[i], &direction = image.directions[i];
        const glm::vec2 offset(point), tangent(direction);
        if (image.owners[i] == 0 || !(point.z * sign > 0.0f)) continue;
        if (!(drawn_opacity(point.w, glm::length(offset), direction.z) >= least_opacity)) continue;
        if (!(glm::dot(tangent, tangent) > 0.5f)) continue;
        const glm::vec2 middle(static_cast<float>(i % static_cast<std::size_t>(width_)) + 0.5f,
                               static_cast<float>(i / static_cast<std::size_t>(width_)) + 0.5f);
        found_.push_back({middle + offset, glm::normalize(tangent), direction.z, glm::length(offset), point.w,
                          image.owners[i], static_cast<std::uint32_t>(i)});
        ++starts_[cell_of(found_.back().place) + 1];
    }
    for (std::size_t i = 1; i < starts_.size(); ++i) starts_[i] += starts_[i - 1];
    claims_.resize(found_.size());
    for (std::size_t i = found_.size(); i-- > 0;) {
        const std::uint32_t at = --starts_[cell_of(found_[i].place) + 1];
        claims_[at] = found_[i];
        claim_of_[found_[i].pixel] = at;
    }
    // What was counted down is now the start of the cell one further.
    starts_.erase(starts_.begin());
    starts_.push_back(static_cast<std::uint32_t>(found_.size()));
}

std::optional<glm::vec2> ClaimedMiddles::nearest(glm::vec2 place, std::uint32_t owner, float reach) const {
    float least = reach;
    std::optional<glm::vec2> best;
    const auto take = [&](glm::vec2 candidate) {
        const float distance = glm::distance(candidate, place);
        if (distance > least) return;
        least = distance;
        best = candidate;
    };
    const auto take_links = [&](const ClaimedMiddle& claim) {
        const int x = static_cast<int>(claim.pixel) % width_, y = static_cast<int>(claim.pixel) / width_;
        for (int v = std::max(0, y - 1); v <= std::min(height_ - 1, y + 1); ++v)
            for (int u = std::max(0, x - 1); u <= std::min(width_ - 1, x + 1); ++u) {
                const std::uint32_t other = claim_of_[index_of(u, v)];
                if (other == no_claim || claims_[other].owner != owner) continue;
                if (glm::distance(claims_[other].place, claim.place) > longest_link) continue;
                take(nearest_on(claim.place, claims_[other].place, place));
            }
    };
    // One end at least of a link that is within reach is no farther than half of it besides.
    each_near(place, reach + 0.5f * longest_link, [&](std::uint32_t i) {
        if (claims_[i].owner == owner) take_links(claims_[i]);
    });
    return best;
}

} // namespace hachure::geometry
