#include <hachure/systems/deform/shape_update.h>

#include <glm/common.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>

namespace hachure {
namespace {

/// So many that handing a range to a thread costs nothing beside it.
constexpr std::size_t range_size = 4096;

/// Up to the rounding that moving the whole model brings: a character that stands still on something that moves is the
/// same shape.
bool same_row(const glm::vec4& a, const glm::vec4& b) {
    constexpr float rounding = 4e-7f;
    const float size = std::max({std::abs(a.x), std::abs(a.y), std::abs(a.z), std::abs(a.w)});
    const glm::vec4 off = glm::abs(a - b);
    return std::max({off.x, off.y, off.z, off.w}) <= rounding * size;
}

bool same_palette(const std::vector<geometry::JointMatrix>& a, const std::vector<geometry::JointMatrix>& b) {
    return std::ranges::equal(a, b, [](const geometry::JointMatrix& x, const geometry::JointMatrix& y) {
        return same_row(x.row[0], y.row[0]) && same_row(x.row[1], y.row[1]) && same_row(x.row[2], y.row[2]);
    });
}

glm::dmat4 matrix_of(const geometry::JointMatrix& joint) {
    return glm::transpose(glm::dmat4(joint.row[0], joint.row[1], joint.row[2], {0, 0, 0, 1}));
}

geometry::Bounds joined(const std::vector<geometry::Bounds>& all) {
    geometry::Bounds result;
    for (const geometry::Bounds& bounds : all) result.include(bounds);
    return result;
}

} // namespace

bool ShapeUpdate::prepare(std::uint32_t mesh_index, const Deform& settings, std::span<const float> weights,
                          std::vector<geometry::JointMatrix>& palette) {
    if (state_->made && state_->mesh == mesh_index && state_->settings == settings &&
        std::ranges::equal(state_->weights, weights) && same_palette(state_->palette, palette))
        return false;
    state_->made = true;
    state_->mesh = mesh_index;
    state_->settings = settings;
    state_->weights.assign(weights.begin(), weights.end());
    state_->palette.swap(palette);
    state_->motions.clear();
    if (settings.method == geometry::SkinMethod::dual_quaternion)
        for (const geometry::JointMatrix& joint : state_->palette)
            state_->motions.push_back(geometry::to_joint_motion(matrix_of(joint)));
    return true;
}

bool ShapeUpdate::morphs() const {
    return std::ranges::any_of(state_->weights, [](float weight) { return weight != 0.0f; });
}

void ShapeUpdate::resize(Deformed& shape) {
    shape_ = &shape;
    const std::size_t count = mesh_->positions.size();
    bounds_.assign((count + range_size - 1) / range_size, {});
    shape.positions.resize(count);
    shape.normals.resize(count);
    shape.tangents.resize(mesh_->tangents.size());
    if (!skins() || !morphs()) return;
    state_->morphed_positions.resize(count);
    state_->morphed_normals.resize(count);
    state_->morphed_tangents.resize(mesh_->tangents.size());
}

void ShapeUpdate::run(std::size_t range) {
    const geometry::VertexRange vertices{range * range_size,
                                         std::min(range_size, mesh_->positions.size() - range * range_size)};
    if (morphs() || !skins()) bounds_[range] = run_morph(vertices);
    if (skins()) bounds_[range] = run_skin(vertices);
}

geometry::Bounds ShapeUpdate::run_morph(geometry::VertexRange range) {
    const bool skinned = skins();
    geometry::MorphJob job{.base_positions = mesh_->positions,
                           .base_normals = mesh_->normals,
                           .base_tangents = mesh_->tangents,
                           .targets = &mesh_->morphs,
                           .weights = state_->weights,
                           .range = range,
                           .positions = skinned ? state_->morphed_positions : shape_->positions,
                           .normals = skinned ? state_->morphed_normals : shape_->normals,
                           .tangents = skinned ? state_->morphed_tangents : shape_->tangents};
    job.run();
    return job.bounds;
}

geometry::Bounds ShapeUpdate::run_skin(geometry::VertexRange range) {
    const bool morphed = morphs();
    geometry::SkinJob job{.method = state_->settings.method,
                          .rest_positions = morphed ? state_->morphed_positions : mesh_->positions,
                          .rest_normals = morphed ? state_->morphed_normals : mesh_->normals,
                          .rest_tangents = morphed ? state_->morphed_tangents : mesh_->tangents,
                          .weights = &mesh_->skin,
                          .palette = state_->palette,
                          .motions = state_->motions,
                          .range = range,
                          .positions = shape_->positions,
                          .normals = shape_->normals,
                          .tangents = shape_->tangents};
    job.run();
    return job.bounds;
}

void ShapeUpdate::finish(std::uint64_t version) {
    shape_->bounds = joined(bounds_);
    shape_->palette = state_->palette;
    shape_->motions = state_->motions;
    shape_->version = version;
    if (state_->settings.normals == DeformedNormals::blended) return;
    geometry::SmoothNormalsJob& job = state_->normals;
    job.positions = shape_->positions;
    job.indices = mesh_->indices;
    job.weld = mesh_->normal_weld;
    job.normals = shape_->normals;
    job.run();
}

} // namespace hachure
