#pragma once

#include <hachure/runtime/animation/clip.h>
#include <hachure/runtime/animation/pose.h>

#include <cstdint>
#include <span>
#include <vector>

namespace hachure::animation {

/// Where in its key times a clip was sampled last, kept from frame to frame by whoever plays it. It only makes sampling
/// faster: results never depend on it, and a cache of another clip is as good as an empty one.
struct SampleCache {
    /// Between which keys a moment lies.
    struct Place {
        std::uint32_t key = 0;   ///< the last key at or before the moment; 0 before the first
        float fraction = 0.0f;   ///< [0, 1] of the way to the next key; 0 before the first key and after the last
        double key_length = 0.0; ///< seconds to the next key
    };
    std::vector<Place> places;        ///< per KeyTimes of the clip
    std::uint64_t keys_looked_at = 0; ///< in all: what searching has cost

    /// Makes room for a clip, so that the first run allocates nothing either.
    void reserve(const Clip& clip);
};

/// A clip at a moment (glTF 2.0, appendix C): steps, straight lines (for rotations spherical ones, the short way
/// round), or cubic Hermite splines whose tangents are scaled by the length between the keys. Before the first key of a
/// track its first value holds, after the last its last. The cost per track does not depend on the clip's length while
/// time moves on; a jump costs the logarithm of its length. Allocates only when the cache grows.
struct SampleClipJob {
    const Clip* clip = nullptr;
    double time = 0.0; ///< seconds of the clip, finite
    SampleCache* cache = nullptr;
    PoseSpan pose; ///< in and out: of the clip's layout; only what the clip moves (Clip::targets) is written
    /// Out: clip->pointer_floats() floats, as Clip::pointers divides them; or empty, then pointers are not sampled.
    std::span<float> pointer_values{};
    /// In and out: per node, the parts (moves_translation | ...) that were written are added; or empty.
    std::span<std::uint8_t> written{};

    /// Asserts that everything is there and sizes agree.
    void validate() const;
    void run();
};

/// One node of a clip at a moment, found by search. What the clip does not move stays as it is in `pose`.
void sample_node(const Clip& clip, std::uint32_t node, double time, JointPose& pose);

} // namespace hachure::animation
