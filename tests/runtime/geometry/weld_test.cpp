#include <hachure/runtime/geometry/weld.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "reference.h"

namespace hachure::geometry {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(Weld, NothingGivesNothing) { EXPECT_THAT(weld_positions({}), IsEmpty()); }

TEST(Weld, GivesTheFirstVertexAtEachPlace) {
    const std::vector<glm::vec3> p{{0, 0, 0}, {1, 0, 0}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}};
    EXPECT_THAT(weld_positions(p), ElementsAre(0, 1, 0, 1, 4, 0));
}

TEST(Weld, TakesBothZerosForOne) {
    const std::vector<glm::vec3> p{{0.0f, -0.0f, 1.0f}, {-0.0f, 0.0f, 1.0f}};
    EXPECT_THAT(weld_positions(p), ElementsAre(0, 0));
}

TEST(Weld, KeepsNeighbouringFloatsApart) {
    const std::vector<glm::vec3> p{{1.0f, 2.0f, 3.0f}, {std::nextafter(1.0f, 2.0f), 2.0f, 3.0f}, {3.0f, 2.0f, 1.0f}};
    EXPECT_THAT(weld_positions(p), ElementsAre(0, 1, 2));
}

TEST(Weld, AgreesWithAnOrderedMapOnAGrid) {
    std::mt19937 random(7);
    std::uniform_int_distribution<int> coordinate(-8, 8);
    std::vector<glm::vec3> p(20000);
    for (glm::vec3& v : p) v = glm::vec3(coordinate(random), coordinate(random), coordinate(random)) * 0.1f;
    EXPECT_EQ(weld_positions(p), reference::weld(p));
}

} // namespace
} // namespace hachure::geometry
