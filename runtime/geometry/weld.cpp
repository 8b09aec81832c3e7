#include <hachure/runtime/assert.h>
#include <hachure/runtime/geometry/weld.h>

#include <glm/geometric.hpp>

#include <bit>

namespace hachure::geometry {
namespace {

/// Mixes the bits of a position; adding zero turns -0 into +0.
std::uint64_t hash(const glm::vec3& p) {
    const auto x = std::bit_cast<std::uint32_t>(p.x + 0.0f);
    const auto y = std::bit_cast<std::uint32_t>(p.y + 0.0f);
    const auto z = std::bit_cast<std::uint32_t>(p.z + 0.0f);
    std::uint64_t h = (static_cast<std::uint64_t>(x) << 32 | y) * 0x9e3779b97f4a7c15u;
    h = (h ^ (h >> 29) ^ z) * 0xbf58476d1ce4e5b9u;
    h = (h ^ (h >> 32)) * 0x94d049bb133111ebu;
    return h ^ (h >> 29);
}

} // namespace

std::vector<std::uint32_t> weld_positions(std::span<const glm::vec3> positions) {
    constexpr std::uint32_t empty = 0xffffffffu;
    HACHURE_ASSERT(positions.size() < empty, "vertices are counted in 32 bits");
    const std::size_t mask = std::bit_ceil(positions.size() * 2 + 1) - 1;
    std::vector<std::uint32_t> slots(mask + 1, empty); // open addressing, at most half full
    std::vector<std::uint32_t> weld(positions.size());
    for (std::uint32_t i = 0; i < positions.size(); ++i) {
        std::size_t slot = hash(positions[i]) & mask;
        while (slots[slot] != empty && positions[slots[slot]] != positions[i]) slot = (slot + 1) & mask;
        if (slots[slot] == empty) slots[slot] = i;
        weld[i] = slots[slot];
    }
    return weld;
}

std::vector<std::uint32_t> weld_normals(std::span<const glm::vec3> positions, std::span<const glm::vec3> normals) {
    constexpr float same = 0.99996f; // cosine of half a degree
    constexpr std::uint32_t none = 0xffffffffu;
    HACHURE_ASSERT(normals.size() == positions.size(), "one normal per vertex");
    std::vector<std::uint32_t> weld = weld_positions(positions);
    // By vertex that stands for a normal: the next one at its place.
    std::vector<std::uint32_t> next(positions.size(), none);
    for (std::uint32_t i = 0; i < positions.size(); ++i) {
        if (weld[i] == i) continue;
        std::uint32_t at = weld[i];
        while (glm::dot(normals[at], normals[i]) < same && next[at] != none) at = next[at];
        if (glm::dot(normals[at], normals[i]) >= same) {
            weld[i] = at;
        } else {
            next[at] = i;
            weld[i] = i;
        }
    }
    return weld;
}

} // namespace hachure::geometry
