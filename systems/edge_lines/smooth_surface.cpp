#include <hachure/runtime/geometry/weld.h>
#include <hachure/systems/edge_lines/smooth_surface.h>

namespace hachure {

SmoothSurface::SmoothSurface(const SurfaceMesh& source)
    : weld_(geometry::weld_positions(source.positions)), normals_(source.positions.size()),
      planes_(source.positions.size()) {}

void SmoothSurface::find_normals(const LineQuery& query) {
    if (normals_version_ == query.version) return;
    normals_job_.positions = query.positions;
    normals_job_.indices = query.mesh->indices;
    normals_job_.weld = weld_;
    normals_job_.normals = normals_;
    normals_job_.run();
    geometry::vertex_planes(query.positions, normals_, planes_);
    normals_version_ = query.version;
}

std::span<const geometry::SurfaceSegment> SmoothSurface::silhouettes(const LineQuery& query) {
    find_normals(query);
    if (!query.deformed && tree_.size() == 0)
        tree_ = geometry::smooth_silhouette_tree(planes_, query.mesh->indices, weld_);
    silhouettes_.positions = query.positions;
    silhouettes_.indices = query.mesh->indices;
    silhouettes_.weld = weld_;
    silhouettes_.planes = planes_;
    silhouettes_.eye = query.eye;
    silhouettes_.tree = query.deformed ? nullptr : &tree_;
    silhouettes_.run();
    return silhouettes_.segments;
}

void SmoothSurface::find_curvature(const LineQuery& query) {
    find_normals(query);
    if (curvature_version_ == query.version) return;
    curvatures_.resize(normals_.size());
    directions_.resize(normals_.size());
    derivatives_.resize(normals_.size());
    curvature_job_.positions = query.positions;
    curvature_job_.normals = normals_;
    curvature_job_.indices = query.mesh->indices;
    curvature_job_.weld = weld_;
    curvature_job_.curvatures = curvatures_;
    curvature_job_.directions = directions_;
    curvature_job_.run();
    derivative_job_.positions = query.positions;
    derivative_job_.normals = normals_;
    derivative_job_.indices = query.mesh->indices;
    derivative_job_.weld = weld_;
    derivative_job_.curvatures = curvatures_;
    derivative_job_.directions = directions_;
    derivative_job_.derivatives = derivatives_;
    derivative_job_.run();
    candidates_ = geometry::suggestive_candidates(query.mesh->indices, weld_, curvatures_);
    curvature_version_ = query.version;
}

std::span<const geometry::SurfaceSegment> SmoothSurface::suggestive_contours(const LineQuery& query) {
    find_curvature(query);
    suggestive_.positions = query.positions;
    suggestive_.normals = normals_;
    suggestive_.indices = query.mesh->indices;
    suggestive_.weld = weld_;
    suggestive_.curvatures = curvatures_;
    suggestive_.directions = directions_;
    suggestive_.derivatives = derivatives_;
    suggestive_.eye = query.eye;
    suggestive_.options.size = query.mesh->bounds.radius();
    suggestive_.options.derivative = query.wanted->suggestive_threshold;
    suggestive_.candidates = candidates_;
    suggestive_.run();
    return suggestive_.segments;
}

} // namespace hachure
