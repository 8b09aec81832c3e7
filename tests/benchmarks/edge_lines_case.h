#pragma once

#include <hachure/runtime/geometry/bounds.h>
#include <hachure/runtime/geometry/select_edges.h>
#include <hachure/runtime/geometry/select_edges_by_tree.h>
#include <hachure/runtime/geometry/shapes.h>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cstdint>
#include <functional>
#include <vector>

namespace hachure::bench {

/// A mesh whose silhouettes are found by all ways.
struct SilhouetteCase {
    std::vector<glm::vec3> positions;
    std::vector<std::uint32_t> indices;
    geometry::Bounds bounds;
    geometry::EdgeTable table;
    std::vector<glm::vec4> planes;
    geometry::PlaneTree tree;
    double build_ms = 0.0; ///< of the tree
    std::vector<std::uint8_t> front;
    std::vector<std::uint32_t> plain; ///< what the plain loop found
    std::size_t plain_count = 0;
    std::vector<geometry::ChosenEdge> chosen;
    geometry::SelectEdgesJob loop;
    geometry::SelectEdgesByTreeJob by_tree;

    SilhouetteCase(std::vector<glm::vec3> p, std::vector<std::uint32_t> i);
    SilhouetteCase(const SilhouetteCase&) = delete;
    SilhouetteCase& operator=(const SilhouetteCase&) = delete;

    /// The eye of a frame: each turns it by a degree around the mesh, at 2.5 times its radius.
    [[nodiscard]] glm::vec4 eye(int frame) const;

    /// The yardstick: a sweep over faces that looks which side the eye sees, and nothing else.
    void plain_faces(const glm::vec4& eye);
    /// The plain loop: that sweep, and one over edges that takes those between front and back.
    void plain_loop(const glm::vec4& eye);
    /// Whether the tree found what the plain loop did.
    [[nodiscard]] bool agree() const;
};

/// Milliseconds a frame of each job, which are given the number of the frame and run in turn within it. Of every frame
/// the best of several rounds counts: other programs only ever add time. Each round goes through all frames, so that a
/// job finds in the caches what it would find after the frame before.
[[nodiscard]] std::vector<double> frame_ms(const std::vector<std::function<void(int)>>& jobs, int frames, int rounds);

} // namespace hachure::bench
