#include <hachure/runtime/assert.h>
#include <hachure/runtime/geometry/skin_blocks.h>

#include <algorithm>

namespace hachure::geometry {

void SkinBlocks::append(std::span<const std::uint32_t> joints, std::span<const float> weights, std::size_t per_vertex) {
    HACHURE_ASSERT(joints.size() == weights.size() && joints.size() <= size * per_vertex, "a block's influences");
    const std::size_t first = joints_.size();
    for (std::size_t i = 0; i < joints.size(); ++i) {
        if (!(weights[i] > 0.0f)) continue;
        const auto own = joints_.begin() + static_cast<std::ptrdiff_t>(first);
        const auto found = std::find(own, joints_.end(), joints[i]);
        const auto at = static_cast<std::size_t>(found - joints_.begin());
        if (found == joints_.end()) {
            joints_.push_back(joints[i]);
            weights_.emplace_back();
        }
        weights_[at].of_vertex[i / per_vertex] = weights[i];
    }
    if (joints_.size() - first > joint_limit) {
        joints_.resize(first);
        weights_.resize(first);
    }
    firsts_.push_back(static_cast<std::uint32_t>(joints_.size()));
}

} // namespace hachure::geometry
