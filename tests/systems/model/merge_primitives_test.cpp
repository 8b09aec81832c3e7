#include <hachure/systems/model/merge_primitives.h>

#include <gtest/gtest.h>

namespace hachure {
namespace {

using assets::Primitive;

TEST(MergePrimitives, PutsNeutralValuesWhereOnlySomeHaveThem) {
    Primitive bare, rich;
    bare.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    bare.indices = {0, 1, 2};
    bare.material = 7;
    rich = bare;
    rich.material = 3;
    rich.indices = {2, 1, 0, 0, 1, 2};
    rich.normals.assign(3, {0, 0, 1});
    rich.texcoords[0].assign(3, {0.5f, 0.25f});
    rich.colors.assign(3, {0.1f, 0.2f, 0.3f, 0.4f});
    const std::vector<Primitive> primitives{bare, rich};
    const SurfaceMesh mesh = merge_primitives(
        "both", primitives, [](std::int32_t index) { return SurfaceMaterial{.name = std::to_string(index)}; });
    EXPECT_EQ(mesh.name, "both");
    EXPECT_EQ(mesh.indices, (std::vector<std::uint32_t>{0, 1, 2, 5, 4, 3, 3, 4, 5}));
    ASSERT_EQ(mesh.submeshes.size(), 2u);
    EXPECT_EQ(mesh.submeshes[0].material.name, "7");
    EXPECT_EQ(mesh.submeshes[1].material.name, "3");
    EXPECT_EQ(mesh.submeshes[1].first_index, 3u);
    EXPECT_EQ(mesh.submeshes[1].index_count, 6u);
    ASSERT_EQ(mesh.colors.size(), 6u);
    EXPECT_EQ(mesh.colors[0], glm::vec4(1.0f));
    EXPECT_EQ(mesh.colors[4], rich.colors[0]);
    EXPECT_EQ(mesh.texcoords[1], glm::vec2(0.0f));
    EXPECT_EQ(mesh.texcoords[5], glm::vec2(0.5f, 0.25f));
    EXPECT_EQ(mesh.normals.size(), 6u);
    EXPECT_TRUE(merge_primitives("bare", std::span(primitives).first(1), [](std::int32_t) {
                    return SurfaceMaterial{};
                }).colors.empty());
}

} // namespace
} // namespace hachure
