// The scripts of samples/scripts do what they say, and docs/scripts.md quotes them as they are.

#include <hachure/components/scene_event.h>
#include <hachure/runtime/app/input.h>
#include <hachure/runtime/ecs/events.h>
#include <hachure/tests/systems/script/script_fixture.h>

#include <filesystem>

namespace hachure::test {
namespace {

std::filesystem::path source(const char* file) { return std::filesystem::path(HACHURE_SOURCE_DIR) / file; }

struct SampleScripts : ScriptTest {
    Entity add_sample(const char* file, const char* name) {
        return world().create_with(Name{name}, Transform{}, Script{source(file).string()});
    }
};

TEST_F(SampleScripts, SpinTurns) {
    const Entity top = add_sample("samples/scripts/spin.lua", "Top");
    Input& input = world().set_resource(Input{});
    for (int i = 0; i < 10; ++i) app.run_frame(0.05);
    EXPECT_NEAR(glm::angle(world().get<Transform>(top).rotation), 0.5, 1e-3);
    const InputEvent space{InputKind::key_down, "space", {}};
    input.take({&space, 1});
    for (int i = 0; i < 5; ++i) app.run_frame(0.05);
    EXPECT_NEAR(glm::angle(world().get<Transform>(top).rotation), 1.5, 1e-3);
    EXPECT_TRUE(errors().empty());
}

TEST_F(SampleScripts, FollowReachesTheLeader) {
    const Entity leader = world().create_with(Name{"Leader"}, Transform{.translation = {5, 0, 0}});
    const Entity hound = add_sample("samples/scripts/follow.lua", "Hound");
    const Entity fly = add_sample("samples/scripts/firefly.lua", "Fly");
    world().add(leader, Gooch{});
    app.run_frame(1.0);
    EXPECT_NEAR(world().get<Transform>(hound).translation.x, 2.0, 1e-5);
    app.run_frame(1.0);
    EXPECT_NEAR(world().get<Transform>(hound).translation.x, 4.0, 1e-5);
    const auto sent = events_since<SceneEvent>(world(), 0);
    ASSERT_EQ(sent.size(), 1u);
    EXPECT_EQ(sent.begin()->name, "reached");
    EXPECT_EQ(sent.begin()->entity, leader);
    send_event(world(), SceneEvent{fly, "reached"});
    send_event(world(), SceneEvent{hound, "stop"});
    world().get_mutable<Transform>(leader).translation.x = 20.0f;
    app.run_frame(1.0);
    EXPECT_NEAR(world().get<Transform>(hound).translation.x, 4.0, 1e-5);
    EXPECT_EQ(world().get<Gooch>(leader).y, 0.8f);
    EXPECT_LE(glm::length(world().get<Transform>(fly).translation), 0.1f);
    EXPECT_TRUE(errors().empty());
}

/// Every run is the same, bit for bit, whatever the addresses are.
TEST(SampleScriptsDeterminism, TwoRunsAgree) {
    const auto run = [] {
        struct Run : SampleScripts {
            void TestBody() override {}
        } scene;
        scene.world().create_with(Name{"Leader"}, Transform{.translation = {5, 0, 0}});
        std::vector<Entity> all{scene.add_sample("samples/scripts/follow.lua", "Hound")};
        for (int i = 0; i < 20; ++i) all.push_back(scene.add_sample("samples/scripts/firefly.lua", "Fly"));
        for (int i = 0; i < 30; ++i) scene.app.run_frame(1.0 / 30);
        std::vector<glm::vec3> places;
        for (const Entity entity : all) places.push_back(scene.world().get<Transform>(entity).translation);
        return places;
    };
    const std::vector<glm::vec3> first = run();
    EXPECT_EQ(first, run());
    EXPECT_NE(first[1], first[2]);
}

TEST(SampleScriptsPage, QuotesThemAsTheyAre) {
    const std::string page = file_text(source("docs/scripts.md"));
    for (const char* const name : {"spin", "follow"}) {
        const std::string text = file_text(source("samples/scripts") / (std::string(name) + ".lua"));
        ASSERT_FALSE(text.empty());
        EXPECT_NE(page.find("```lua\n" + text + "```\n"), page.npos) << name;
    }
}

} // namespace
} // namespace hachure::test
