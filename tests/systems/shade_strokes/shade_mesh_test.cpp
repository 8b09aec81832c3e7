#include <hachure/tests/support/shade_rig.h>

#include <gtest/gtest.h>

#include <numeric>
#include <queue>

namespace hachure::test {
namespace {

ShadeMesh mesh_of(const geometry::Shape& shape, std::uint32_t cells) {
    return make_shade_mesh(
        {.positions = shape.positions, .normals = shape.normals, .indices = shape.indices, .cells = cells});
}

double area_of(const geometry::Shape& shape) {
    double sum = 0.0;
    for (std::size_t i = 0; i < shape.indices.size(); i += 3) {
        const glm::dvec3 a(shape.positions[shape.indices[i]]), b(shape.positions[shape.indices[i + 1]]),
            c(shape.positions[shape.indices[i + 2]]);
        sum += 0.5 * glm::length(glm::cross(b - a, c - a));
    }
    return sum;
}

/// Cells cover the surface once, whether triangles are gathered or divided, and are of about one size.
TEST(ShadeMeshTest, CellsDivideAnyMeshEvenly) {
    for (const std::uint32_t level : {1u, 3u, 6u}) { // 80, 1280 and 81920 triangles
        const geometry::Shape shape = geometry::icosphere(2.0, level);
        const ShadeMesh mesh = mesh_of(shape, 1000);
        const double total = area_of(shape);
        EXPECT_NEAR(std::accumulate(mesh.cells.area.begin(), mesh.cells.area.end(), 0.0), total, 1e-3 * total);
        EXPECT_GT(mesh.cell_count(), 700u);
        EXPECT_LT(mesh.cell_count(), 1500u);
        const double usual = total / static_cast<double>(mesh.cell_count());
        std::size_t odd = 0;
        for (const float area : mesh.cells.area) odd += area < 0.4 * usual || area > 2.0 * usual ? 1 : 0;
        EXPECT_LT(odd, mesh.cell_count() / 20) << level;
    }
}

TEST(ShadeMeshTest, AtomsAndTheirCornersAgree) {
    const ShadeMesh mesh = mesh_of(geometry::icosphere(1.0, 0), 2000);
    ASSERT_GT(mesh.cells.parts[0], 3u);
    for (std::uint32_t t = 0; t < 20; ++t) {
        double area = 0.0;
        for (std::uint32_t a = mesh.cells.first_atom[t]; a < mesh.cells.first_atom[t + 1]; ++a) {
            const auto c = mesh.cells.atom_corners(t, a);
            EXPECT_EQ(mesh.cells.atom_at(t, (c[0] + c[1] + c[2]) / 3.0), a);
            EXPECT_EQ(mesh.cells.triangle_of(a), t);
            area += glm::length(glm::cross(c[1] - c[0], c[2] - c[0]));
        }
        EXPECT_NEAR(area, std::sqrt(3.0), 1e-9); // of the triangle of weights, doubled
    }
}

/// Points of a cell lie in it, and evenly: their mean is the cell's middle.
TEST(ShadeMeshTest, PointsLieInTheirCell) {
    const ShadeMesh mesh = mesh_of(geometry::icosphere(1.0, 4), 300);
    for (std::uint32_t c = 0; c < mesh.cell_count(); ++c) {
        for (int i = 0; i < 10; ++i) {
            const ShadeCells::Point point = mesh.cells.point_in(c, 0.1 * i + 0.05, 0.3, 0.06 * i);
            EXPECT_EQ(mesh.cells.cell_at(point.triangle, point.weight), c);
        }
    }
}

/// The second principal direction of a cylinder is its axis, of a torus the way around its hole.
TEST(ShadeMeshTest, StrokesRunAlongTheSecondPrincipalDirection) {
    const geometry::Shape torus = geometry::irregular_torus(1.0, 0.3, 96, 48, 0.3, 3);
    const ShadeMesh mesh = mesh_of(torus, 1000);
    double worst = 0.0, sum = 0.0;
    for (std::size_t v = 0; v < mesh.sheets.positions.size(); ++v) {
        const glm::dvec3 p = mesh.sheets.positions[v];
        const glm::dvec3 around = glm::normalize(glm::dvec3(-p.z, 0.0, p.x));
        const double off = std::acos(std::min(1.0, std::abs(glm::dot(glm::dvec3(mesh.directions.along[v]), around))));
        worst = std::max(worst, off);
        sum += off;
    }
    EXPECT_LT(sum / static_cast<double>(mesh.sheets.positions.size()), 0.06);
    EXPECT_LT(worst, 0.35);
}

/// On a sphere every direction is principal: a disturbance in the last bits must not decide which is taken.
TEST(ShadeMeshTest, UmbilicsKeepTheirDirectionUnderRounding) {
    geometry::Shape shape = geometry::icosphere(1.0, 4);
    const ShadeMesh before = mesh_of(shape, 500);
    for (std::size_t v = 0; v < shape.positions.size(); ++v)
        for (int k = 0; k < 3; ++k)
            shape.positions[v][k] = std::nextafter(shape.positions[v][k], (v + k) % 2 == 0 ? 2.0f : -2.0f);
    const ShadeMesh after = mesh_of(shape, 500);
    std::size_t turned = 0;
    for (std::size_t v = 0; v < before.directions.along.size(); ++v)
        if (std::abs(glm::dot(before.directions.along[v], after.directions.along[v])) < 0.999f) ++turned;
    EXPECT_LE(turned, 2u) << "of " << before.directions.along.size();
}

TEST(ShadeMeshTest, ReportsWhatEndsChains) {
    EXPECT_EQ(shade_mesh_report(mesh_of(geometry::icosphere(1.0, 2), 100)), "");
    EXPECT_EQ(shade_mesh_report(mesh_of(geometry::plane(1.0, 2), 100)), "8 border edges");
    geometry::Shape fins; // three triangles at one edge, one of them twice, and one without three places
    fins.positions = {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {-1, 0, 0}, {0, 0, 1}};
    fins.indices = {0, 1, 2, 1, 0, 3, 0, 1, 4, 0, 1, 4, 2, 2, 3};
    const std::string report = shade_mesh_report(mesh_of(fins, 100));
    EXPECT_NE(report.find("1 edges of more than two triangles"), std::string::npos) << report;
    EXPECT_NE(report.find("1 repeated triangles"), std::string::npos) << report;
    EXPECT_NE(report.find("1 triangles with two corners at one place"), std::string::npos) << report;
}

} // namespace
} // namespace hachure::test
