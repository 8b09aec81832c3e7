#include <gtest/gtest.h>
#include <meshoptimizer.h>

#include "chain_checks.h"

namespace hachure::test {
namespace {

/// Every triangle cut into four, `times` times over, where it lies: the same surface.
geometry::Shape subdivided(geometry::Shape shape, int times) {
    for (int n = 0; n < times; ++n) {
        std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
        const auto middle = [&](std::uint32_t a, std::uint32_t b) {
            const auto [found, is_new] =
                middles.try_emplace(std::minmax(a, b), static_cast<std::uint32_t>(shape.positions.size()));
            if (is_new) {
                shape.positions.push_back(0.5f * (shape.positions[a] + shape.positions[b]));
                shape.normals.push_back(glm::normalize(shape.normals[a] + shape.normals[b]));
            }
            return found->second;
        };
        std::vector<std::uint32_t> indices;
        for (std::size_t i = 0; i < shape.indices.size(); i += 3) {
            const std::uint32_t a = shape.indices[i], b = shape.indices[i + 1], c = shape.indices[i + 2];
            const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
            indices.insert(indices.end(), {a, ab, ca, ab, b, bc, ca, bc, c, ab, bc, ca});
        }
        shape.indices = std::move(indices);
    }
    return shape;
}

double shade_of(const ShadeRig& rig) {
    double sum = 0.0, area = 0.0;
    for (std::size_t c = 0; c < rig.needed().size(); ++c) {
        sum += double(rig.chains().cells[c].delivered) * rig.mesh().cells.area[c];
        area += rig.mesh().cells.area[c];
    }
    return sum / area;
}

/// The same surface gets the same ink, however finely it is divided (1 to 64 times as many triangles).
TEST(ShadeInkTest, SubdivisionChangesNoInk) {
    const geometry::Shape coarse = geometry::irregular_torus(1.0, 0.4, 36, 18, 0.3, 5);
    double first_shade = 0.0, first_ink = 0.0;
    for (int times = 0; times <= 3; ++times) {
        ShadeRig rig(subdivided(coarse, times), 1500);
        rig.step_sun(0.0);
        if (times == 0) {
            first_shade = shade_of(rig);
            first_ink = rig.ink();
            EXPECT_GT(first_ink, 0.2);
        }
        RecordProperty("ink" + std::to_string(times), std::to_string(rig.ink()));
        EXPECT_NEAR(shade_of(rig), first_shade, 0.1 * first_shade) << times;
        EXPECT_NEAR(rig.ink(), first_ink, 0.1 * first_ink) << times;
    }
}

/// And whatever the shape of its triangles.
TEST(ShadeInkTest, ShapeOfTrianglesChangesNoInk) {
    const auto ink = [](std::uint32_t around, std::uint32_t across) {
        ShadeRig rig(geometry::torus(1.0, 0.4, around, across), 1500);
        rig.step_sun(0.0);
        return rig.ink();
    };
    const double even = ink(100, 40);
    EXPECT_NEAR(ink(500, 24), even, 0.1 * even);
    EXPECT_NEAR(ink(40, 300), even, 0.1 * even);
}

/// The bunny, decimated.
TEST(ShadeInkTest, DecimationChangesLittleInk) {
    if (!std::filesystem::exists(bunny_file)) GTEST_SKIP() << "the bunny is not there";
    const geometry::Shape bunny = shape_of_file(bunny_file);
    std::vector<double> inks;
    for (const std::size_t triangles : {70000u, 17000u, 5000u}) {
        geometry::Shape shape = bunny;
        if (3 * triangles < shape.indices.size()) {
            shape.indices.resize(meshopt_simplify(shape.indices.data(), bunny.indices.data(), bunny.indices.size(),
                                                  &bunny.positions[0].x, bunny.positions.size(), sizeof(glm::vec3),
                                                  3 * triangles, 0.1f));
            EXPECT_NEAR(double(shape.indices.size() / 3), double(triangles), 0.05 * double(triangles));
        }
        ShadeRig rig(std::move(shape), 3000);
        rig.step_sun(30.0);
        inks.push_back(rig.ink());
    }
    EXPECT_GT(inks[0], 0.15);
    EXPECT_NEAR(inks[1], inks[0], 0.15 * inks[0]);
    EXPECT_NEAR(inks[2], inks[0], 0.15 * inks[0]);
}

/// What the jobs account is what is drawn: the patches between ribs cover it.
TEST(ShadeInkTest, AccountsWhatIsDrawn) {
    ShadeRig rig(geometry::irregular_torus(1.0, 0.4, 120, 60, 0.2, 5), 1500);
    rig.step_sun(0.0);
    EXPECT_NEAR(rig.ink(), shade_of(rig), 0.05 * shade_of(rig));
}

} // namespace
} // namespace hachure::test
