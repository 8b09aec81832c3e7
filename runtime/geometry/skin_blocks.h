#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace hachure::geometry {

/// Influences by blocks of neighbouring vertices. Neighbours follow the same joints: 16 vertices of a character follow
/// about 3 together, where one by one they name 64 of them. A block lists its joints once, each with the weights of
/// all its vertices, so that a joint's matrix is fetched once per block and no vertex looks anything up.
class SkinBlocks {
public:
    /// Vertices of a block; the last one of a mesh may have fewer.
    static constexpr std::size_t size = 16;

    /// Most joints of a block; one that follows more lists none. (15 in 16 blocks of 15 characters follow at most 8.)
    static constexpr std::size_t joint_limit = 12;

    /// The weights of a block's vertices for one joint: zero where a vertex does not follow it, and past the mesh.
    struct alignas(64) Weights {
        std::array<float, size> of_vertex{};
    };

    [[nodiscard]] std::size_t block_count() const { return firsts_.size() - 1; }

    /// Palette entries that vertices [16 block, 16 block + 16) follow, and as many weights of theirs.
    [[nodiscard]] std::span<const std::uint32_t> joints(std::size_t block) const {
        return {joints_.data() + firsts_[block], firsts_[block + 1] - firsts_[block]};
    }
    [[nodiscard]] std::span<const Weights> weights(std::size_t block) const {
        return {weights_.data() + firsts_[block], firsts_[block + 1] - firsts_[block]};
    }

    /// The next block's influences: of `joints` and `weights`, the same number per vertex, those above zero.
    void append(std::span<const std::uint32_t> joints, std::span<const float> weights, std::size_t per_vertex);

    /// All blocks one after the other; where each begins, and after the last, where it ends.
    [[nodiscard]] std::span<const std::uint32_t> all_firsts() const { return firsts_; }
    [[nodiscard]] std::span<const std::uint32_t> all_joints() const { return joints_; }
    [[nodiscard]] std::span<const Weights> all_weights() const { return weights_; }

private:
    std::vector<std::uint32_t> firsts_{0};
    std::vector<std::uint32_t> joints_;
    std::vector<Weights> weights_;
};

} // namespace hachure::geometry
