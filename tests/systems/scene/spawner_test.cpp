#include <hachure/components/gooch.h>
#include <hachure/components/scene.h>
#include <hachure/components/surface.h>
#include <hachure/components/transform.h>
#include <hachure/runtime/scene/mesh_store.h>
#include <hachure/runtime/scene/spawner.h>
#include <hachure/tests/systems/scene/scene_fixture.h>

namespace hachure::test {
namespace {

class SpawnerTest : public SceneTest {
protected:
    Entity spawn(const SpawnRequest& request) { return world().resource<Spawner>().spawn(world(), request); }
};

TEST_F(SpawnerTest, ReadsFilesOnceAndGivesThemTheScenesStyle) {
    static_cast<void>(load(R"({"name": "Ground", "model": "die.obj"})", R"(, "style": "gooch")"));
    const Entity first = spawn({.what = "lone.obj", .parent = named("Ground"), .name = "Tree"});
    EXPECT_EQ(world().parent(first), named("Ground"));
    EXPECT_EQ(named("Ground/Tree"), first);
    EXPECT_TRUE(has<Gooch>("Tree/lone"));
    const Entity second = spawn({.what = "lone.obj"});
    EXPECT_FALSE(world().parent(second));
    EXPECT_EQ(world().resource<MeshStore>().mesh_count(), 2u);
    EXPECT_EQ(world().children(second).size(), 1u);
    for (int i = 0; i < 5; ++i) static_cast<void>(spawn({.what = "die.obj"}));
    EXPECT_EQ(world().resource<MeshStore>().mesh_count(), 2u) << "the scene has it already";
    EXPECT_EQ(world().query<const Surface>().count(), 8u);
}

TEST_F(SpawnerTest, SpawnsScenesAndCopies) {
    write("sub/tree.scene.json", R"({"hachure_scene": 1, "entities": [{"name": "Leaf", "model": "../die.obj"}]})");
    static_cast<void>(load(R"({"name": "A", "gooch": {"b": 0.3}, "children": [{"name": "Below"}]})"));
    const Entity tree = spawn({.what = "sub/tree.scene.json", .name = "T"});
    EXPECT_EQ(world().parent(named("T/Leaf")), tree);
    const Entity copy = spawn({.what = "A", .name = "Copy"});
    EXPECT_EQ(world().get<Gooch>(copy).b, 0.3f);
    EXPECT_TRUE(named("Copy/Below"));
    EXPECT_EQ(world().get<SceneReference>(tree).file, folder_ / "sub/tree.scene.json");
}

TEST_F(SpawnerTest, RefusesWhatLeavesTheFolderAndWhatIsNotThere) {
    write("in/a.scene.json", R"({"hachure_scene": 1, "entities": [{"name": "A"}]})");
    static_cast<void>(load_scene(*app_, folder_ / "in/a.scene.json"));
    const std::size_t before = world().size();
    for (const std::string& what : {std::string("../die.obj"), (folder_ / "die.obj").string(), std::string("none.obj"),
                                    std::string("Nobody"), std::string("a.txt"), std::string("%2e%2e/die.obj")})
        EXPECT_THROW(static_cast<void>(spawn({.what = what})), Error) << what;
    write("in/broken.scene.json", R"({"hachure_scene": 1, "entities": [{"name": "X"}, {"gooch": {"b": 9}}]})");
    EXPECT_THROW(static_cast<void>(spawn({.what = "broken.scene.json"})), Error);
    EXPECT_EQ(world().size(), before);
}

} // namespace
} // namespace hachure::test
