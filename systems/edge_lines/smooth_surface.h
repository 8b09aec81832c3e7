#pragma once

#include <hachure/runtime/geometry/curvature.h>
#include <hachure/runtime/geometry/curvature_derivative.h>
#include <hachure/runtime/geometry/normals.h>
#include <hachure/runtime/geometry/smooth_silhouettes.h>
#include <hachure/runtime/geometry/suggestive_contours.h>
#include <hachure/systems/edge_lines/line_query.h>

#include <cstdint>
#include <span>
#include <vector>

namespace hachure {

/// The smooth surface that a mesh stands for, and its lines inside triangles. What does not depend on the eye is kept
/// for the mesh's own shape, and found anew for each other shape.
class SmoothSurface {
public:
    explicit SmoothSurface(const SurfaceMesh& source);

    /// Valid until the next call.
    [[nodiscard]] std::span<const geometry::SurfaceSegment> silhouettes(const LineQuery& query);
    [[nodiscard]] std::span<const geometry::SurfaceSegment> suggestive_contours(const LineQuery& query);

private:
    void find_normals(const LineQuery& query);
    void find_curvature(const LineQuery& query);

    static constexpr std::uint64_t not_yet = ~std::uint64_t{0};

    std::vector<std::uint32_t> weld_;
    geometry::SmoothNormalsJob normals_job_;
    std::vector<glm::vec3> normals_;
    std::vector<glm::vec4> planes_;
    std::uint64_t normals_version_ = not_yet; ///< of the shape that normals and planes are of
    geometry::PlaneTree tree_;                ///< of the mesh's own shape
    geometry::SmoothSilhouettesJob silhouettes_;

    geometry::CurvatureJob curvature_job_;
    geometry::CurvatureDerivativeJob derivative_job_;
    std::vector<glm::vec2> curvatures_;
    std::vector<glm::vec3> directions_;
    std::vector<glm::vec4> derivatives_;
    std::uint64_t curvature_version_ = not_yet;
    std::vector<std::uint32_t> candidates_; ///< triangles that can hold a suggestive contour
    geometry::SuggestiveContoursJob suggestive_;
};

} // namespace hachure
