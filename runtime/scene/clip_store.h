#pragma once

#include <hachure/runtime/animation/clip.h>
#include <hachure/runtime/animation/pose.h>

#include <cstdint>
#include <deque>
#include <utility>
#include <vector>

namespace hachure {

/// The clips of one model, and the pose that its file shows.
struct ModelClips {
    animation::ClipSet set;
    animation::Pose rest;       ///< of the set's layout
    std::vector<bool> animated; ///< per node: whether any clip moves it; ClipStore fills it in
};

/// The clips of a world's models, by index. A resource; what is added stays until the world ends, and references stay
/// valid.
class ClipStore {
public:
    std::uint32_t add(ModelClips clips) {
        clips.animated.assign(clips.set.layout.nodes(), false);
        for (const animation::Clip& clip : clips.set.clips)
            for (const animation::ClipTarget& target : clip.targets) clips.animated[target.node] = true;
        models_.push_back(std::move(clips));
        return static_cast<std::uint32_t>(models_.size() - 1);
    }
    [[nodiscard]] const ModelClips& clips(std::uint32_t index) const { return models_.at(index); }

private:
    std::deque<ModelClips> models_;
};

} // namespace hachure
