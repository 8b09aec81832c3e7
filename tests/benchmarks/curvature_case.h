#pragma once

#include <hachure/runtime/geometry/curvature.h>
#include <hachure/tests/support/curved_case.h>

#include <cstdint>
#include <vector>

namespace hachure::bench {

/// A curvature job on a surface whose curvature is known.
class CurvatureCase {
public:
    CurvatureCase(test::CurvedKind kind, double noise, std::uint32_t cells);
    CurvatureCase(const CurvatureCase&) = delete;
    CurvatureCase& operator=(const CurvatureCase&) = delete;

    struct Figures {
        double us;      ///< of one core per vertex: the best of some rounds, once everything is allocated
        double rms;     ///< %
        double degrees; ///< 95th percentile
    };
    /// `rings`: 0 for the method's own.
    [[nodiscard]] Figures measure(geometry::CurvatureMethod method, std::uint32_t rings, int rounds);

    [[nodiscard]] std::size_t vertices() const { return mesh_.positions.size(); }

private:
    test::CurvedCase mesh_;
    geometry::VertexNeighbours neighbours_;
    std::vector<glm::vec2> curvatures_;
    std::vector<glm::vec3> directions_;
};

} // namespace hachure::bench
