#include <hachure/components/animation.h>
#include <hachure/components/animation_states.h>
#include <hachure/components/camera.h>
#include <hachure/runtime/error.h>
#include <hachure/runtime/scene/spawner.h>
#include <hachure/tests/systems/timeline/timeline_scene.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace hachure::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

struct TimelineActionsTest : ::testing::Test, TimelineScene {
    /// Spawns an entity, as one who loads files would.
    void set_spawner() {
        world().set_resource(Spawner{[this](World& all, const SpawnRequest& request) {
            spawned.push_back(request.what);
            if (request.what == "broken.glb") throw Error("broken.glb", "is broken");
            const Entity entity = all.create_with(Name{request.name}, Transform{});
            if (request.parent) all.set_parent(entity, request.parent);
            return entity;
        }});
    }
    std::vector<std::string> spawned;
};

const char* const bells = R"({"duration": 4, "actions": [
    {"at": 4, "event": "end"}, {"at": 1, "event": "one"}, {"at": 2, "event": "two"}, {"at": 2, "event": "too"},
    {"at": 0, "event": "start"}]})";

TEST_F(TimelineActionsTest, EventsHappenOnceAndInOrder) {
    const Entity player = play(bells);
    run(0.0);
    EXPECT_THAT(heard, ElementsAre("start"));
    EXPECT_EQ(about.front(), player);
    run(0.0, 3);
    EXPECT_THAT(heard, ElementsAre("start"));
    run(1.0, 4);
    EXPECT_THAT(heard, ElementsAre("start", "one", "two", "too", "end"));
    run(1.0, 4);
    EXPECT_EQ(heard.size(), 5u) << "it is over";
}

TEST_F(TimelineActionsTest, LargeStepsPassAllRounds) {
    timeline(play(bells)).repeat = Repeat::loop;
    run(10.5);
    EXPECT_THAT(heard, ElementsAre("start", "one", "two", "too", "end", "start", "one", "two", "too", "end", "start",
                                   "one", "two", "too"));
}

/// Whatever the speed and the steps: so many events happen in so much time.
TEST_F(TimelineActionsTest, StepsDoNotMatter) {
    for (const char* repeat : {"once", "loop", "ping_pong"})
        for (const double speed : {1.0, -1.0, 0.37, 13.0, 250.0}) {
            std::vector<std::string> whole;
            for (const int steps : {1, 7, 240}) {
                TimelineScene scene;
                const Entity player = scene.play(bells);
                Timeline& timeline = scene.timeline(player);
                timeline.repeat = repeat[0] == 'o' ? Repeat::once : repeat[0] == 'l' ? Repeat::loop : Repeat::ping_pong;
                timeline.speed = static_cast<float>(speed);
                // Not a moment at which anything happens, which rounding could put to either side.
                scene.run(7.713 / steps, steps);
                if (whole.empty()) whole = scene.heard;
                EXPECT_EQ(scene.heard, whole) << repeat << " " << speed << " in " << steps << " steps";
                EXPECT_FALSE(whole.empty());
            }
        }
}

TEST_F(TimelineActionsTest, AJumpPassesNothing) {
    const Entity player = play(bells);
    run(0.5);
    heard.clear();
    timeline(player).time = 2.5;
    run(0.1);
    EXPECT_THAT(heard, IsEmpty());
    run(2.0);
    EXPECT_THAT(heard, ElementsAre("end"));
    timeline(player).time = 0.0;
    run(0.0);
    EXPECT_THAT(heard, ElementsAre("end", "start")) << "it begins anew";
}

TEST_F(TimelineActionsTest, PausedItDoesNothing) {
    const Entity player = play(bells);
    timeline(player).playing = false;
    run(1.0, 3);
    EXPECT_THAT(heard, IsEmpty());
    timeline(player).playing = true;
    run(1.0);
    EXPECT_THAT(heard, ElementsAre("start", "one"));
}

TEST_F(TimelineActionsTest, WhatIsSpawnedIsThereForWhatFollowsInTheSameStep) {
    set_spawner();
    const Entity ground = add("Ground"), ship = add("Ship");
    play(R"({"tracks": [{"target": "Tree/transform.scale.y", "keys": [[0, 1], [4, 5]]}], "actions": [
        {"at": 1, "spawn": "tree.glb", "name": "Tree", "parent": "Ground"},
        {"at": 1, "event": "grown", "on": "Ground/Tree"},
        {"at": 2, "parent": "Tree", "to": "Ship"}, {"at": 3, "parent": "Tree", "to": null},
        {"at": 3.5, "destroy": "Tree"}]})");
    testing::internal::CaptureStderr();
    run(0.5);
    run(1.0);
    EXPECT_THAT(spawned, ElementsAre("tree.glb"));
    ASSERT_EQ(world().children(ground).size(), 1u);
    const Entity tree = world().children(ground)[0];
    EXPECT_THAT(about, ElementsAre(tree));
    EXPECT_EQ(place(tree).scale.y, 2.5f) << "its track moves it at once";
    run(1.0);
    EXPECT_EQ(world().parent(tree), ship);
    run(0.75);
    EXPECT_FALSE(world().parent(tree));
    run(1.0);
    EXPECT_FALSE(world().alive(tree));
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "") << "what comes and goes is not missed";
}

TEST_F(TimelineActionsTest, ClipsStatesAndCameras) {
    const Entity fox = add("Fox"), one = add("One"), two = add("Two");
    world().add(fox, Animation{.clip = "Walk"});
    animation::StateMachine machine;
    machine.states = {{"idle"}};
    machine.parameters = {{"calm"}, {"speed"}};
    world().add(fox, AnimationStates::make(machine));
    world().add(one, Camera{});
    world().add(two, Camera{.active = false});
    play(R"({"actions": [{"at": 1, "clip": "Run", "on": "Fox"}, {"at": 1, "state": {"speed": 2.5, "calm": true},
        "on": "Fox"}, {"at": 1, "camera": "Two"}]})");
    run(0.5);
    EXPECT_EQ(world().get<Animation>(fox).clip, "Walk");
    run(0.5);
    EXPECT_EQ(world().get<Animation>(fox).clip, "Run");
    EXPECT_THAT(world().get<AnimationStates>(fox).parameters, ElementsAre(1.0f, 2.5f));
    EXPECT_FALSE(world().get<Camera>(one).active);
    EXPECT_TRUE(world().get<Camera>(two).active);
}

TEST_F(TimelineActionsTest, ATimelineMayDestroyItself) {
    const Entity player = play(add("me"), R"({"tracks": [{"target": "transform.scale.x", "keys": [[0, 1], [2, 2]]}],
        "actions": [{"at": 1, "destroy": "me"}, {"at": 1, "event": "late", "on": "me"}]})");
    testing::internal::CaptureStderr();
    run(1.5, 3);
    EXPECT_FALSE(world().alive(player));
    EXPECT_THAT(heard, IsEmpty());
    EXPECT_THAT(testing::internal::GetCapturedStderr(), HasSubstr("there is no entity 'me'"));
}

TEST_F(TimelineActionsTest, WhatCannotBeDoneIsAWarning) {
    set_spawner();
    const Entity top = add("Top");
    add("Below", top);
    play(R"({"repeat": "loop", "actions": [
        {"at": 1, "spawn": "broken.glb"}, {"at": 1, "spawn": "a.glb", "parent": "Nobody"},
        {"at": 1, "parent": "Top", "to": "Below"}, {"at": 1, "clip": "Run", "on": "Top"},
        {"at": 1, "state": {"speed": 1}, "on": "Top"}, {"at": 1, "camera": "Top"}, {"at": 1, "destroy": "Ghost"}]})");
    testing::internal::CaptureStderr();
    run(1.0, 3);
    EXPECT_EQ(testing::internal::GetCapturedStderr(),
              "hachure: warning: timeline: broken.glb: is broken\n"
              "hachure: warning: timeline: there is no entity 'Nobody'\n"
              "hachure: warning: timeline: 'Top' can't be put below 'Below', which is itself below it\n"
              "hachure: warning: timeline: 'Top' is no model that plays clips\n"
              "hachure: warning: timeline: 'Top' has no animation states\n"
              "hachure: warning: timeline: 'Top' is no camera\n"
              "hachure: warning: timeline: there is no entity 'Ghost'\n");
}

TEST_F(TimelineActionsTest, WithoutASpawnerItSaysSoOnce) {
    play(R"({"repeat": "loop", "duration": 1, "actions": [{"at": 0.5, "spawn": "tree.glb"}]})");
    testing::internal::CaptureStderr();
    run(1.0, 3);
    EXPECT_EQ(testing::internal::GetCapturedStderr(),
              "hachure: warning: timeline: nothing can be spawned here, as 'tree.glb'\n");
}

} // namespace
} // namespace hachure::test
