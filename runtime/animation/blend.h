#pragma once

#include <hachure/runtime/animation/pose.h>

#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace hachure::animation {

/// A pose among others that are blended.
struct BlendLayer {
    ConstPoseSpan pose;
    float weight = 1.0f;           ///< at least 0; relative to the other layers'
    std::span<const float> mask{}; ///< per node, at least 0, multiplies the weight; or empty for 1 everywhere
};

/// The weighted mean of poses, for cross-fades and blend spaces: every node's weights are divided by their sum. Where
/// the sum is 0 the node takes the rest pose; where one layer alone has a weight, its pose bit for bit.
///
/// Rotations are blended as normalised sums of quaternions of one hemisphere. For two rotations that is the same arc as
/// slerp's, passed with a speed that is off by at most 1 degree for rotations 90 degrees apart (8 for opposite ones),
/// exact at both ends and in the middle. A fade's speed along the arc is nobody's data (between keys it is, and there
/// slerp is used), and the sum has no trigonometry and treats any number of layers alike.
struct BlendPosesJob {
    std::span<const BlendLayer> layers;
    ConstPoseSpan rest;
    PoseSpan out;                       ///< may be the pose of any layer or `rest`
    const PoseLayout* layout = nullptr; ///< of the poses; only needed where they have morph weights

    /// Asserts that sizes agree and weights are finite and at least 0.
    void validate() const;
    void run();
};

/// Fades a pose towards another, where a mask allows it: an upper body over a walk. At weight * mask = 1 the other pose
/// replaces it bit for bit, at 0 nothing changes.
struct OverlayPoseJob {
    PoseSpan pose; ///< in and out
    ConstPoseSpan over;
    float weight = 1.0f;                ///< [0, 1]
    std::span<const float> mask{};      ///< per node, [0, 1]; or empty for 1 everywhere
    const PoseLayout* layout = nullptr; ///< of the poses; only needed where they have morph weights

    /// Asserts that sizes agree and weights are in range.
    void validate() const;
    void run();
};

/// Adds the difference between two poses to a pose: breathing or recoil over whatever else moves. Differences are taken
/// in the frame of the parent: translations and morph weights add, rotations multiply from the left, scales multiply
/// (they add where the reference's is 0). At weight 1 on the reference itself the source comes out; a source that is
/// the reference changes nothing, bit for bit.
struct AddPoseJob {
    PoseSpan pose; ///< in and out
    ConstPoseSpan source;
    ConstPoseSpan reference;
    float weight = 1.0f;                ///< [0, 1]
    std::span<const float> mask{};      ///< per node, [0, 1]; or empty for 1 everywhere
    const PoseLayout* layout = nullptr; ///< of the poses; only needed where they have morph weights

    /// Asserts that sizes agree and weights are in range.
    void validate() const;
    void run();
};

/// Sets the mask of a node and all that hangs below it to `weight`. `mask` has one element per node.
void mask_branch(const PoseLayout& layout, std::uint32_t node, float weight, std::span<float> mask);

/// The mask that is `inside` for the first node of this name and all below it, `outside` elsewhere; none when no node
/// has that name.
[[nodiscard]] std::optional<std::vector<float>> make_mask(const PoseLayout& layout, std::string_view node,
                                                          float inside = 1.0f, float outside = 0.0f);

} // namespace hachure::animation
