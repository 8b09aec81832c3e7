#pragma once

#include <hachure/runtime/scene/draw_list.h>
#include <hachure/runtime/scene/mesh_store.h>
#include <hachure/runtime/scene/view.h>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace hachure {

/// A triangle that is drawn, on the screen: counter-clockwise, in pixels; its depth in the window is a plane there.
struct ScreenTriangle {
    std::array<glm::dvec2, 3> corners;
    glm::dvec3 depth; ///< at (x, y): depth.x * x + depth.y * y + depth.z
};

/// The triangles of a view by the cells of a grid over the picture, for those who ask what lies before a line. Only
/// cells that a line passes are filled. In double precision; keeps its memory from view to view.
class Occluders {
public:
    static constexpr int cell_size = 8; ///< pixels

    /// Begins a view: no triangles, no cells wanted.
    void begin(const View& view);

    /// Lines pass this way, pixels.
    void want(const glm::dvec2& start, const glm::dvec2& end);

    /// Fills the wanted cells from everything that the view draws.
    void fill(const DrawList& list, const MeshStore& store, const View& view);

    /// Calls `visit(index of the triangle)` for each triangle in the cells that a line passes; for some twice.
    template <class Visit> void each_along(const glm::dvec2& start, const glm::dvec2& end, Visit&& visit) const {
        each_cell(start, end, [&](std::size_t cell) {
            for (std::uint32_t i = cell_starts_[cell]; i < cell_starts_[cell + 1]; ++i) visit(cell_triangles_[i]);
        });
    }

    [[nodiscard]] std::span<const ScreenTriangle> triangles() const { return triangles_; }

private:
    struct CellBox {
        int left, right, bottom, top; ///< inclusive; empty when left > right
    };
    [[nodiscard]] CellBox cells_of(const glm::dvec2& low, const glm::dvec2& high) const;

    /// Cells along a line: those of a box around each row's part of it.
    template <class Visit> void each_cell(const glm::dvec2& start, const glm::dvec2& end, Visit&& visit) const;

    void add_item(const DrawItem& item, const SurfaceMesh& mesh, const View& view);
    void add_clipped(const std::array<glm::dvec4, 3>& clip, bool one_sided);
    void add_triangle(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, bool one_sided);
    void sort_into_cells();

    glm::dvec2 viewport_{1.0};
    int columns_ = 0, rows_ = 0;
    std::vector<std::uint8_t> wanted_; ///< per cell
    std::vector<ScreenTriangle> triangles_;
    std::vector<CellBox> boxes_;             ///< per triangle
    std::vector<std::uint32_t> cell_starts_; ///< per cell and one more
    std::vector<std::uint32_t> cell_triangles_;
    std::vector<std::uint32_t> cell_next_; ///< scratch
    std::vector<glm::dvec4> clip_;         ///< scratch: vertices of an item
    std::vector<glm::dvec3> screen_;       ///< scratch: the same on the screen
};

template <class Visit> void Occluders::each_cell(const glm::dvec2& start, const glm::dvec2& end, Visit&& visit) const {
    const CellBox all = cells_of(glm::min(start, end), glm::max(start, end));
    const glm::dvec2 along = end - start;
    for (int row = all.bottom; row <= all.top; ++row) {
        // Where the line is within this row of cells.
        glm::dvec2 part(0.0, 1.0);
        if (all.top > all.bottom && along.y != 0.0) {
            const double enter = (row * cell_size - start.y) / along.y,
                         leave = ((row + 1) * cell_size - start.y) / along.y;
            part = glm::clamp(glm::dvec2(glm::min(enter, leave), glm::max(enter, leave)), 0.0, 1.0);
        }
        const glm::dvec2 p = start + part.x * along, q = start + part.y * along;
        // A little wider: what rounding puts on the other side of a cell's rim is looked at, too.
        const double y = (row + 0.5) * cell_size;
        const CellBox box = cells_of({glm::min(p.x, q.x) - 1e-6, y}, {glm::max(p.x, q.x) + 1e-6, y});
        for (int column = box.left; column <= box.right; ++column)
            visit(static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
                  static_cast<std::size_t>(column));
    }
}

} // namespace hachure
