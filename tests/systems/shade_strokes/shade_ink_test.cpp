#include <hachure/tests/support/divided_mesh.h>

#include <gtest/gtest.h>

#include "chain_checks.h"

namespace hachure::test {
namespace {

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
        geometry::Shape shape = decimated(bunny, triangles);
        EXPECT_NEAR(double(shape.indices.size() / 3), double(triangles), 0.05 * double(triangles));
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
