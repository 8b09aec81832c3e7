#pragma once

#include <hachure/runtime/geometry/bounds.h>
#include <hachure/runtime/geometry/skin.h>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace hachure::geometry {

/// Displacements of one morph target as a file has them; each array is empty or has one element per vertex, finite.
struct MorphDeltas {
    std::span<const glm::vec3> positions{};
    std::span<const glm::vec3> normals{};
    std::span<const glm::vec3> tangents{};
};

/// The targets of one mesh, packed: an array of displacements keeps only the vertices that move where that is smaller.
class MorphTargets {
public:
    /// Every array of every target is empty or has `vertex_count` elements, which is asserted.
    MorphTargets() = default;
    MorphTargets(std::size_t vertex_count, std::span<const MorphDeltas> targets);

    [[nodiscard]] std::size_t vertex_count() const { return vertex_count_; }
    [[nodiscard]] std::size_t size() const { return targets_.size(); }
    [[nodiscard]] std::size_t bytes() const; ///< of the displacements and their vertices

    /// One array of displacements: of the listed vertices, rising, or of all when none are listed.
    struct Array {
        std::vector<std::uint32_t> vertices;
        std::vector<glm::vec3> deltas;
    };
    struct Target {
        Array positions, normals, tangents;
    };
    [[nodiscard]] const Target& operator[](std::size_t target) const { return targets_[target]; }

private:
    std::size_t vertex_count_ = 0;
    std::vector<Target> targets_;
};

/// Adds weighted displacements to a mesh: out = base + sum of weight * delta, normals and tangents made unit again. A
/// target of weight zero costs nothing; a weight that is not finite counts as zero. Results do not depend on how a mesh
/// is cut into ranges. Allocates nothing.
struct MorphJob {
    std::span<const glm::vec3> base_positions{};
    std::span<const glm::vec3> base_normals{};  ///< unit; or empty, as `normals` then is
    std::span<const glm::vec4> base_tangents{}; ///< xyz unit, w = +-1; or empty
    const MorphTargets* targets = nullptr;      ///< of as many vertices; not owned
    std::span<const float> weights{};           ///< one per target; any size, also negative
    VertexRange range{};                        ///< which vertices to morph

    std::span<glm::vec3> positions{}; ///< out: one per vertex; those outside the range stay untouched
    std::span<glm::vec3> normals{};   ///< out: unit; the base's where nothing is left of it
    std::span<glm::vec4> tangents{};  ///< out: the same; w is the base's
    Bounds bounds{};                  ///< out: of the positions of the range

    /// Asserts that sizes agree.
    void validate() const;
    void run();
};

/// Runs `job` over its range on all threads. The same result as `job.run()`.
void morph_in_parallel(MorphJob& job);

} // namespace hachure::geometry
