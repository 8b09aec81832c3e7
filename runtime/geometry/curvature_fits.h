#pragma once

#include <hachure/runtime/geometry/surface_patch.h>
#include <hachure/runtime/geometry/vertex_neighbours.h>

#include <glm/vec3.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace hachure::geometry {

/// The mesh of a CurvatureJob.
struct CurvedMesh {
    std::span<const glm::vec3> positions, normals;
    std::span<const std::uint32_t> weld;
    const VertexNeighbours& neighbours;
};

/// How CurvatureJob fits polynomials, on all threads, and what it keeps for that from run to run.
///
/// `choose` fits degree 4 to 3 rings of vertices. What is left over is noise: its variance, averaged around each
/// vertex, times the gain of the fit is the error to be expected. Where that is not small, 5, 8 and 12 rings are
/// fitted, too. Noise falls with more rings and bias grows: as far as the difference to fewer rings exceeds what noise
/// explains, it is bias. Fits are averaged with weights that fall with the square of the expected squared error, so the
/// best prevails and nothing jumps while a mesh deforms. docs/curvature.md derives it.
class CurvatureFits {
public:
    static constexpr std::array<std::uint32_t, 4> level_rings{3, 5, 8, 12};

    struct Fit {
        float e, f, g; ///< as in SurfaceFit
        bool quartic;  ///< as in SurfaceFit
        double gain;   ///< as in SurfaceFit
        double bias;   ///< what the polynomial leaves out: its expected part of the squared error, 1/metre^2
    };

    /// One kind of fit everywhere.
    void fit(const CurvedMesh& mesh, const PatchExtent& extent);
    /// As many rings as suit the noise around each vertex. `flat`: a curvature that counts as none, 1/metre.
    void choose(const CurvedMesh& mesh, double tolerance, double flat);

    /// Of a vertex that stands for itself, after either.
    [[nodiscard]] const Fit& result(std::size_t vertex) const { return fits_[0][vertex]; }
    /// The expected square of its error, 1/metre^2.
    [[nodiscard]] double error(std::size_t vertex) const { return error_[vertex]; }

private:
    void each_vertex(const CurvedMesh& mesh, const std::function<void(std::uint32_t, PatchScratch&)>& body);
    void fit_level(const CurvedMesh& mesh, std::size_t level);
    void pool_noise(const CurvedMesh& mesh);
    void find_bias(const CurvedMesh& mesh, std::size_t level);
    void blend(std::uint32_t vertex);
    [[nodiscard]] bool is_good(std::uint32_t vertex, std::size_t level) const;
    [[nodiscard]] double noise_error(std::uint32_t vertex, std::size_t level) const {
        return noise_[vertex] * fits_[level][vertex].gain;
    }

    std::array<std::vector<Fit>, level_rings.size()> fits_; ///< those of more rings are empty until noise asks for them
    std::vector<double> error_;
    std::vector<double> residual_, noise_;    ///< variances, metre^2: about the vertex's polynomial, and around it
    std::vector<std::uint8_t> unsure_, last_; ///< whether more rings are wanted; the last level that is fitted
    std::vector<PatchScratch> threads_;
    double tolerance_ = 0.0, flat_ = 0.0;
};

} // namespace hachure::geometry
