#include <hachure/runtime/geometry/shapes.h>
#include <hachure/systems/abstracted_lines/mesh_widths.h>

#include <gtest/gtest.h>

#include <cstddef>

namespace hachure {
namespace {

SurfaceMesh painted(const std::vector<glm::vec4>& colors) {
    SurfaceMesh mesh;
    mesh.name = "painted";
    const geometry::Shape shape = geometry::plane(1.0, 1);
    mesh.positions = shape.positions;
    mesh.indices = shape.indices;
    mesh.colors = colors;
    return mesh;
}

AbstractedLines by(LineAbstraction how, PaintChannel channel = PaintChannel::alpha) {
    return {.width_by = how, .paint_channel = channel};
}

TEST(MeshWidthsTest, PaintIsAChannelOfTheColours) {
    MeshStore store;
    const std::uint32_t mesh = store.add(painted({{0, 0.25f, 1, 0.5f}, {1, 0, 0, 1}, {2, -1, 0, 0}, {0.5f, 1, 0, 0}}));
    MeshWidths widths;
    const auto factors = [&](PaintChannel channel) {
        std::vector<float> result;
        for (const glm::vec3& factor : widths.find(store, mesh, by(LineAbstraction::paint, channel))->factors)
            result.push_back(factor.x);
        return result;
    };
    EXPECT_EQ(factors(PaintChannel::red), (std::vector<float>{0, 1, 1, 0.5f}));
    EXPECT_EQ(factors(PaintChannel::green), (std::vector<float>{0.25f, 0, 0, 1}));
    EXPECT_EQ(factors(PaintChannel::alpha), (std::vector<float>{0.5f, 1, 0, 0}));
}

TEST(MeshWidthsTest, AMeshWithoutColoursIsNotPaintedAndSaysSoOnce) {
    MeshStore store;
    const std::uint32_t mesh = store.add(painted({}));
    MeshWidths widths;
    testing::internal::CaptureStderr();
    for (const PaintChannel channel : {PaintChannel::red, PaintChannel::alpha, PaintChannel::red})
        EXPECT_EQ(widths.find(store, mesh, by(LineAbstraction::paint, channel)), nullptr);
    const std::string said = testing::internal::GetCapturedStderr();
    EXPECT_NE(said.find("the mesh 'painted' has no vertex colours"), std::string::npos) << said;
    EXPECT_EQ(said.find("warning"), said.rfind("warning")) << said;
}

TEST(MeshWidthsTest, EdgesAreMeasuredOncePerMesh) {
    MeshStore store;
    const std::uint32_t one = store.add(painted({})), other = store.add(painted({}));
    MeshWidths widths;
    const VertexWidths* found = widths.find(store, one, by(LineAbstraction::edge_length));
    ASSERT_NE(found, nullptr);
    EXPECT_EQ(found->factors.size(), store.mesh(one).positions.size());
    for (const glm::vec3& factor : found->factors) {
        EXPECT_GT(factor.x, 0.8f);
        EXPECT_LE(factor.x, 1.0f);
    }
    EXPECT_EQ(widths.find(store, one, by(LineAbstraction::edge_length, PaintChannel::red)), found);
    EXPECT_NE(widths.find(store, other, by(LineAbstraction::edge_length))->version, found->version);
    for (const LineAbstraction none : {LineAbstraction::constant, LineAbstraction::depth})
        EXPECT_EQ(widths.find(store, one, by(none)), nullptr);
}

} // namespace
} // namespace hachure
