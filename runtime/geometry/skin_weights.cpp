#include <hachure/runtime/assert.h>
#include <hachure/runtime/geometry/skin_weights.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>

namespace hachure::geometry {
namespace {

/// One joint that a vertex follows.
struct Influence {
    std::uint32_t joint;
    double weight;
};

/// Those of one vertex: at most two sets of four.
struct Influences {
    std::array<Influence, 8> of{};
    std::size_t count = 0;
    bool negative = false, non_finite = false, out_of_range = false;

    /// Adds one as a file has it, or notes why not.
    void add(std::uint32_t joint, float weight, std::size_t joint_count) {
        if (!std::isfinite(weight)) {
            non_finite = true;
        } else if (weight < 0.0f) {
            negative = true;
        } else if (weight > 0.0f && joint >= joint_count) {
            out_of_range = true;
        } else if (weight > 0.0f) {
            const auto end = of.begin() + static_cast<std::ptrdiff_t>(count);
            const auto same = std::find_if(of.begin(), end, [&](const Influence& i) { return i.joint == joint; });
            if (same == end) of[count++] = {joint, 0.0};
            same->weight += weight;
        }
    }

    /// The most significant first; equal ones by their joints, so that the order of a file does not matter. By
    /// insertion, as fits so few.
    void sort() {
        const auto before = [](const Influence& a, const Influence& b) {
            return a.weight != b.weight ? a.weight > b.weight : a.joint < b.joint;
        };
        for (std::size_t i = 1; i < count; ++i)
            for (std::size_t k = i; k > 0 && before(of[k], of[k - 1]); --k) std::swap(of[k], of[k - 1]);
    }

    [[nodiscard]] double sum(std::size_t n) const {
        double total = 0.0;
        for (std::size_t k = 0; k < n; ++k) total += of[k].weight;
        return total;
    }
};

/// How many bytes hold each of `count` different indices.
std::size_t index_bytes(std::size_t count) {
    if (count <= 256) return 1;
    return count <= 65536 ? 2 : 4;
}

} // namespace

class SkinWeightPacker {
public:
    SkinWeightPacker(std::size_t vertex_count, std::size_t joint_count, std::size_t influences) {
        HACHURE_ASSERT(joint_count < std::numeric_limits<std::uint32_t>::max(), "joints are counted in 32 bits");
        packed_.vertex_count_ = vertex_count;
        packed_.joint_count_ = joint_count;
        packed_.influences_ = influences;
        packed_.joint_bytes_ = index_bytes(joint_count + 1);
        packed_.joints_.resize(vertex_count * influences * packed_.joint_bytes_);
        packed_.weights_.resize(vertex_count * influences);
    }

    /// Takes the influences of one vertex, sorted.
    void put(std::size_t vertex, const Influences& all) {
        const std::size_t kept = std::min(all.count, packed_.influences_);
        note(all, kept);
        if (kept == 0) return put_unweighted(vertex);
        const double total = all.sum(kept);
        for (std::size_t k = 0; k < packed_.influences_; ++k) {
            put_joint(vertex, k, k < kept ? all.of[k].joint : all.of[0].joint);
            packed_.weights_[vertex * packed_.influences_ + k] =
                k < kept ? static_cast<float>(all.of[k].weight / total) : 0.0f;
        }
    }

    [[nodiscard]] SkinWeights take() {
        for (std::size_t v = 0; v < packed_.vertex_count_; v += SkinBlocks::size) put_block(v);
        return std::move(packed_);
    }

private:
    void note(const Influences& all, std::size_t kept) {
        SkinWeightRepairs& repairs = packed_.repairs_;
        repairs.negative += all.negative;
        repairs.non_finite += all.non_finite;
        repairs.out_of_range += all.out_of_range;
        repairs.truncated += kept < all.count;
        repairs.without_weight += all.count == 0;
        repairs.unnormalised += all.count > 0 && std::abs(all.sum(all.count) - 1.0) > 1e-3;
    }

    void put_unweighted(std::size_t vertex) {
        for (std::size_t k = 0; k < packed_.influences_; ++k)
            put_joint(vertex, k, static_cast<std::uint32_t>(packed_.joint_count_));
        packed_.weights_[vertex * packed_.influences_] = 1.0f;
    }

    void put_joint(std::size_t vertex, std::size_t k, std::uint32_t joint) {
        const std::size_t at = (vertex * packed_.influences_ + k) * packed_.joint_bytes_;
        const auto narrow = static_cast<std::uint8_t>(joint);
        const auto middle = static_cast<std::uint16_t>(joint);
        const void* bytes = &joint;
        if (packed_.joint_bytes_ == 1) bytes = &narrow;
        if (packed_.joint_bytes_ == 2) bytes = &middle;
        std::memcpy(&packed_.joints_[at], bytes, packed_.joint_bytes_);
    }

    /// The block that begins with a vertex.
    void put_block(std::size_t first) {
        const std::size_t n = packed_.influences_, end = std::min(first + SkinBlocks::size, packed_.vertex_count_);
        std::array<std::uint32_t, 8 * SkinBlocks::size> joints;
        for (std::size_t i = 0; i < (end - first) * n; ++i) joints[i] = packed_.joint(first + i / n, i % n);
        packed_.blocks_.append(std::span(joints).first((end - first) * n),
                               packed_.weights().subspan(first * n, (end - first) * n), n);
    }

    SkinWeights packed_;
};

namespace {

template <class Joints> struct Sets {
    std::size_t joint_count;
    std::span<const Joints> joints[2];
    std::span<const glm::vec4> weights[2];

    [[nodiscard]] Influences of(std::size_t vertex) const {
        Influences all;
        for (int set = 0; set < 2; ++set)
            for (int k = 0; k < 4 && !joints[set].empty(); ++k)
                all.add(joints[set][vertex][k], weights[set][vertex][k], joint_count);
        all.sort();
        return all;
    }
};

template <class Joints> SkinWeights pack(std::size_t vertex_count, const Sets<Joints>& sets, InfluenceLimit limit) {
    for (int set = 0; set < 2; ++set) {
        HACHURE_ASSERT(sets.joints[set].size() == sets.weights[set].size(), "each joint has a weight");
        HACHURE_ASSERT(sets.joints[set].empty() || sets.joints[set].size() == vertex_count, "one element per vertex");
    }
    bool eight = false;
    if (limit == InfluenceLimit::as_needed && !sets.joints[1].empty())
        for (std::size_t v = 0; v < vertex_count && !eight; ++v) eight = sets.of(v).count > 4;
    SkinWeightPacker packer(vertex_count, sets.joint_count, eight ? 8 : 4);
    for (std::size_t v = 0; v < vertex_count; ++v) packer.put(v, sets.of(v));
    return packer.take();
}

} // namespace

std::uint32_t SkinWeights::joint(std::size_t vertex, std::size_t k) const {
    const std::size_t at = vertex * influences_ + k;
    if (joint_bytes_ == 1) return static_cast<std::uint32_t>(joints_[at]);
    if (joint_bytes_ == 2) {
        std::uint16_t joint = 0;
        std::memcpy(&joint, &joints_[2 * at], 2);
        return joint;
    }
    std::uint32_t joint = 0;
    std::memcpy(&joint, &joints_[4 * at], 4);
    return joint;
}

SkinWeights pack_skin_weights(std::size_t vertex_count, std::size_t joint_count, std::span<const glm::u16vec4> joints0,
                              std::span<const glm::vec4> weights0, std::span<const glm::u16vec4> joints1,
                              std::span<const glm::vec4> weights1, InfluenceLimit limit) {
    return pack(vertex_count, Sets<glm::u16vec4>{joint_count, {joints0, joints1}, {weights0, weights1}}, limit);
}

SkinWeights pack_skin_weights(std::size_t vertex_count, std::size_t joint_count, std::span<const glm::uvec4> joints0,
                              std::span<const glm::vec4> weights0, std::span<const glm::uvec4> joints1,
                              std::span<const glm::vec4> weights1, InfluenceLimit limit) {
    return pack(vertex_count, Sets<glm::uvec4>{joint_count, {joints0, joints1}, {weights0, weights1}}, limit);
}

std::vector<std::string> skin_weight_warnings(const SkinWeightRepairs& repairs, std::string_view name) {
    const std::pair<std::uint32_t, const char*> kinds[] = {
        {repairs.without_weight, "follow no joint and stay at rest"},
        {repairs.unnormalised, "have weights whose sum is not 1; they were normalised"},
        {repairs.negative, "have negative weights, taken as zero"},
        {repairs.non_finite, "have weights that are not finite, taken as zero"},
        {repairs.out_of_range, "follow joints that the skin does not have, left out"},
        {repairs.truncated, "have too many influences; the least were left out"},
    };
    std::vector<std::string> lines;
    for (const auto& [count, what] : kinds)
        if (count > 0) lines.push_back(fmt::format("{}: {} vertices {}", name, count, what));
    return lines;
}

} // namespace hachure::geometry
