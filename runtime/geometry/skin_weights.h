#pragma once

#include <hachure/runtime/geometry/skin_blocks.h>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace hachure::geometry {

/// What `pack_skin_weights` found wrong with the influences of a file; counts of vertices.
struct SkinWeightRepairs {
    std::uint32_t without_weight = 0; ///< no influence was left: the vertex follows the palette's last entry
    std::uint32_t unnormalised = 0;   ///< the weights' sum was off 1 by more than 1e-3
    std::uint32_t negative = 0;       ///< a weight below zero counted as zero
    std::uint32_t non_finite = 0;     ///< a weight that is no number or infinite counted as zero
    std::uint32_t out_of_range = 0;   ///< a weight above zero of a joint that the skin doesn't have was dropped
    std::uint32_t truncated = 0;      ///< the least of more influences than asked for were dropped

    [[nodiscard]] bool any() const {
        return without_weight || unnormalised || negative || non_finite || out_of_range || truncated;
    }
};

/// One line per kind of repair: "NAME: 12 vertices have no joint and stay at rest".
[[nodiscard]] std::vector<std::string> skin_weight_warnings(const SkinWeightRepairs& repairs, std::string_view name);

/// The influences of the vertices of one mesh, valid and packed: the most significant first, each joint at most once
/// per vertex, no weight below zero, their sum 1 up to rounding. Influences that a vertex lacks repeat its first joint
/// with weight zero. Made by `pack_skin_weights`, constant afterwards.
class SkinWeights {
public:
    [[nodiscard]] std::size_t vertex_count() const { return vertex_count_; }

    /// Influences of each vertex: 4 or 8.
    [[nodiscard]] std::size_t influences() const { return influences_; }

    /// Joints of the skin.
    [[nodiscard]] std::size_t joint_count() const { return joint_count_; }

    /// How many entries a palette needs: one per joint, and a last one for vertices that follow none.
    [[nodiscard]] std::size_t palette_size() const { return joint_count_ + 1; }

    /// Bytes of a packed joint index: 1 with up to 256 palette entries, 2 with up to 65536, else 4.
    [[nodiscard]] std::size_t joint_bytes() const { return joint_bytes_; }

    /// Palette entry and weight of influence `k` < `influences()` of a vertex.
    [[nodiscard]] std::uint32_t joint(std::size_t vertex, std::size_t k) const;
    [[nodiscard]] float weight(std::size_t vertex, std::size_t k) const { return weights_[vertex * influences_ + k]; }

    /// `influences()` per vertex; joints in the width of `joint_bytes()`.
    [[nodiscard]] std::span<const std::byte> packed_joints() const { return joints_; }
    [[nodiscard]] std::span<const float> weights() const { return weights_; }

    /// The same influences by blocks of vertices.
    [[nodiscard]] const SkinBlocks& blocks() const { return blocks_; }

    [[nodiscard]] const SkinWeightRepairs& repairs() const { return repairs_; }

private:
    friend class SkinWeightPacker;

    std::size_t vertex_count_ = 0, influences_ = 4, joint_count_ = 0, joint_bytes_ = 1;
    std::vector<std::byte> joints_;
    std::vector<float> weights_;
    SkinBlocks blocks_;
    SkinWeightRepairs repairs_;
};

/// How many influences to keep per vertex.
enum class InfluenceLimit : std::uint8_t {
    as_needed, ///< 8 where a vertex has more than 4, else 4
    four,
};

/// Packs the influences of a mesh whose file has one set (JOINTS_0, WEIGHTS_0) or two; `joints1` and `weights1` may be
/// empty, as may all four (no vertex then follows a joint; `vertex_count` says how many there are). Else each has one
/// element per vertex. Values may be anything: what is wrong is repaired and counted.
[[nodiscard]] SkinWeights pack_skin_weights(std::size_t vertex_count, std::size_t joint_count,
                                            std::span<const glm::u16vec4> joints0, std::span<const glm::vec4> weights0,
                                            std::span<const glm::u16vec4> joints1 = {},
                                            std::span<const glm::vec4> weights1 = {},
                                            InfluenceLimit limit = InfluenceLimit::as_needed);

/// The same for skins of more joints than 16 bits count.
[[nodiscard]] SkinWeights pack_skin_weights(std::size_t vertex_count, std::size_t joint_count,
                                            std::span<const glm::uvec4> joints0, std::span<const glm::vec4> weights0,
                                            std::span<const glm::uvec4> joints1 = {},
                                            std::span<const glm::vec4> weights1 = {},
                                            InfluenceLimit limit = InfluenceLimit::as_needed);

} // namespace hachure::geometry
