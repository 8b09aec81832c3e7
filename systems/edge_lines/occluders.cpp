#include <hachure/systems/edge_lines/occluders.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>

#include <algorithm>
#include <cmath>

namespace hachure {
namespace {

bool before_near(const glm::dvec4& clip) { return clip.z > clip.w; }

glm::dvec3 on_screen(const glm::dvec4& clip, const glm::dvec2& viewport) {
    return glm::dvec3((glm::dvec2(clip) / clip.w * 0.5 + 0.5) * viewport, clip.z / clip.w);
}

double cross(const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.y - a.y * b.x; }

} // namespace

void Occluders::begin(const View& view) {
    viewport_ = {view.width, view.height};
    columns_ = (view.width + cell_size - 1) / cell_size;
    rows_ = (view.height + cell_size - 1) / cell_size;
    wanted_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), 0);
    triangles_.clear();
    boxes_.clear();
}

Occluders::CellBox Occluders::cells_of(const glm::dvec2& low, const glm::dvec2& high) const {
    const auto cell = [](double at, int count) {
        return static_cast<int>(std::clamp(std::floor(at / cell_size), -1.0, static_cast<double>(count)));
    };
    return {std::max(cell(low.x, columns_), 0), std::min(cell(high.x, columns_), columns_ - 1),
            std::max(cell(low.y, rows_), 0), std::min(cell(high.y, rows_), rows_ - 1)};
}

void Occluders::want(const glm::dvec2& start, const glm::dvec2& end) {
    each_cell(start, end, [&](std::size_t cell) { wanted_[cell] = 1; });
}

void Occluders::fill(const DrawList& list, const MeshStore& store, const View& view) {
    for (const DrawItem& item : list.items) add_item(item, store.mesh(item.mesh), view);
    sort_into_cells();
}

void Occluders::add_item(const DrawItem& item, const SurfaceMesh& mesh, const View& view) {
    const bool deformed = item.shape.version != 0 && !item.shape.on_gpu;
    const std::span<const glm::vec3> positions = deformed ? item.shape.positions : std::span(mesh.positions);
    const glm::dmat4 clip_from_entity = glm::dmat4(view.clip_from_world) * glm::dmat4(item.world_from_entity);
    clip_.resize(positions.size());
    screen_.resize(positions.size());
    for (std::size_t i = 0; i < positions.size(); ++i) {
        clip_[i] = clip_from_entity * glm::dvec4(glm::dvec3(positions[i]), 1.0);
        if (!before_near(clip_[i])) screen_[i] = on_screen(clip_[i], viewport_);
    }
    for (const Submesh& submesh : mesh.submeshes)
        for (std::uint32_t i = submesh.first_index; i + 2 < submesh.first_index + submesh.index_count; i += 3) {
            std::array<std::uint32_t, 3> v{mesh.indices[i], mesh.indices[i + 1], mesh.indices[i + 2]};
            if (item.mirrored) std::swap(v[1], v[2]);
            const bool one_sided = !submesh.material.double_sided;
            if (before_near(clip_[v[0]]) || before_near(clip_[v[1]]) || before_near(clip_[v[2]]))
                add_clipped({clip_[v[0]], clip_[v[1]], clip_[v[2]]}, one_sided);
            else
                add_triangle(screen_[v[0]], screen_[v[1]], screen_[v[2]], one_sided);
        }
}

/// Cuts a triangle at the near plane: what is left is a polygon of three or four corners.
void Occluders::add_clipped(const std::array<glm::dvec4, 3>& clip, bool one_sided) {
    std::array<glm::dvec3, 4> corners;
    std::size_t count = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::dvec4 &a = clip[i], &b = clip[(i + 1) % 3];
        const double inside_a = a.w - a.z, inside_b = b.w - b.z;
        if (inside_a >= 0.0) corners[count++] = on_screen(a, viewport_);
        if ((inside_a >= 0.0) != (inside_b >= 0.0))
            corners[count++] = on_screen(glm::mix(a, b, inside_a / (inside_a - inside_b)), viewport_);
    }
    for (std::size_t i = 2; i < count; ++i) add_triangle(corners[0], corners[i - 1], corners[i], one_sided);
}

void Occluders::add_triangle(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, bool one_sided) {
    const glm::dvec2 low = glm::min(glm::dvec2(a), glm::min(glm::dvec2(b), glm::dvec2(c))),
                     high = glm::max(glm::dvec2(a), glm::max(glm::dvec2(b), glm::dvec2(c)));
    const CellBox box = cells_of(low, high);
    bool needed = false;
    for (int row = box.bottom; row <= box.top && !needed; ++row)
        for (int column = box.left; column <= box.right && !needed; ++column)
            needed = wanted_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
                             static_cast<std::size_t>(column)] != 0;
    if (!needed) return;
    const glm::dvec3 ab = b - a, ac = c - a;
    const double area = cross(glm::dvec2(ab), glm::dvec2(ac));
    // Seen edge on it hides nothing, and its plane's slope is rounding.
    const double longest = glm::max(glm::length(glm::dvec2(ab)), glm::length(glm::dvec2(ac)));
    if (std::abs(area) <= 1e-6 * longest || (one_sided && area < 0.0)) return;
    // The gradient of depth over the screen, from the two sides at a.
    const glm::dvec2 slope((ab.z * ac.y - ac.z * ab.y) / area, (ac.z * ab.x - ab.z * ac.x) / area);
    ScreenTriangle triangle{{glm::dvec2(a), glm::dvec2(b), glm::dvec2(c)},
                            {slope.x, slope.y, a.z - slope.x * a.x - slope.y * a.y}};
    if (area < 0.0) std::swap(triangle.corners[1], triangle.corners[2]);
    triangles_.push_back(triangle);
    boxes_.push_back(box);
}

void Occluders::sort_into_cells() {
    const std::size_t cells = wanted_.size();
    const auto each_wanted = [&](const CellBox& box, auto&& visit) {
        for (int row = box.bottom; row <= box.top; ++row)
            for (int column = box.left; column <= box.right; ++column) {
                const std::size_t cell = static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
                                         static_cast<std::size_t>(column);
                if (wanted_[cell]) visit(cell);
            }
    };
    cell_starts_.assign(cells + 1, 0);
    for (const CellBox& box : boxes_) each_wanted(box, [&](std::size_t cell) { ++cell_starts_[cell + 1]; });
    for (std::size_t i = 0; i < cells; ++i) cell_starts_[i + 1] += cell_starts_[i];
    cell_triangles_.resize(cell_starts_[cells]);
    cell_next_.assign(cell_starts_.begin(), cell_starts_.end() - 1);
    for (std::uint32_t i = 0; i < boxes_.size(); ++i)
        each_wanted(boxes_[i], [&](std::size_t cell) { cell_triangles_[cell_next_[cell]++] = i; });
}

} // namespace hachure
