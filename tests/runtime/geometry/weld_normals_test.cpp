#include <hachure/runtime/geometry/weld.h>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>

namespace hachure::geometry {
namespace {

TEST(WeldNormalsTest, JoinsSeamsAndKeepsHardEdges) {
    const glm::vec3 a{0, 0, 0}, b{1, 0, 0}, up{0, 0, 1}, side{1, 0, 0};
    const glm::vec3 nearly = glm::normalize(glm::vec3{0.005f, 0, 1});
    const std::vector<glm::vec3> positions{a, a, b, a, a, b, b};
    const std::vector<glm::vec3> normals{up, side, up, nearly, side, side, up};
    EXPECT_EQ(weld_normals(positions, normals), (std::vector<std::uint32_t>{0, 1, 2, 0, 1, 5, 2}));
}

TEST(WeldNormalsTest, ManyNormalsAtOnePlace) {
    std::vector<glm::vec3> positions(100, glm::vec3{1, 2, 3}), normals;
    for (int i = 0; i < 100; ++i) {
        const float angle = 0.6f * static_cast<float>(i % 10);
        normals.emplace_back(std::cos(angle), std::sin(angle), 0.0f);
    }
    const std::vector<std::uint32_t> weld = weld_normals(positions, normals);
    for (std::uint32_t i = 0; i < 100; ++i) EXPECT_EQ(weld[i], i % 10);
}

} // namespace
} // namespace hachure::geometry
