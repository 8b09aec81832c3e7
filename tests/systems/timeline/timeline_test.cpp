#include <hachure/components/camera.h>
#include <hachure/components/light.h>
#include <hachure/components/world_transform.h>
#include <hachure/runtime/parallel.h>
#include <hachure/tests/systems/timeline/timeline_scene.h>

#include <gtest/gtest.h>

#include <cstring>

namespace hachure::test {
namespace {

struct TimelineTest : ::testing::Test, TimelineScene {};

const char* const walk =
    R"({"tracks": [{"target": "Fox/transform.translation", "keys": [[0, [0,0,0]], [2, [4,0,0]]]}]})";

TEST_F(TimelineTest, ATrackMovesAFieldOfTheEntityItNames) {
    const Entity fox = add("Fox");
    play(walk);
    run(0.0);
    EXPECT_EQ(place(fox).translation, glm::vec3(0));
    run(0.5);
    EXPECT_EQ(place(fox).translation, glm::vec3(1, 0, 0));
    run(5.0);
    EXPECT_EQ(place(fox).translation, glm::vec3(4, 0, 0)) << "it stays at the end";
}

TEST_F(TimelineTest, AnEmptyPathIsTheEntityItself) {
    const Entity self = play(add("it"), R"({"tracks": [{"target": "transform.scale.y", "keys": [[0, 1], [1, 3]]}]})");
    run(0.5);
    EXPECT_EQ(place(self).scale, glm::vec3(1, 2, 1)) << "one element, the others stay";
}

TEST_F(TimelineTest, RotationsColorsFlagsOptionsTextsAndEntities) {
    app.add_component<Camera>();
    app.add_component<Light>();
    const Entity fox = add("Fox");
    world().add(fox, Camera{});
    world().add(fox, Light{});
    play(fox, R"({"tracks": [
        {"target": "transform.rotation", "keys": [[0, [0,0,0,1]], [2, [0,1,0,0]]]},
        {"target": "camera.active", "keys": [[0, true], [1, false]]},
        {"target": "camera.projection", "keys": [[0, "perspective"], [1, "orthographic"]]},
        {"target": "name.text", "keys": [[0, "Fox"], [1, "Wolf"]]},
        {"target": "light.color", "interpolation": "step", "keys": [[0, [1,1,1]], [1, "#ff0000"]]}]})");
    run(0.5);
    EXPECT_NEAR(place(fox).rotation.w, std::cos(0.125 * 3.14159265), 1e-6) << "a quarter of half a turn";
    EXPECT_TRUE(world().get<Camera>(fox).active);
    run(0.5);
    EXPECT_FALSE(world().get<Camera>(fox).active);
    EXPECT_EQ(world().get<Camera>(fox).projection, Projection::orthographic);
    EXPECT_EQ(world().get<Name>(fox).text, "Wolf");
    EXPECT_EQ(world().get<Light>(fox).color, glm::vec3(1, 0, 0));
}

TEST_F(TimelineTest, SplinesThatLeaveTheRangeOfAFieldStayAtItsEnd) {
    app.add_component<Camera>();
    const Entity eye = add("Eye");
    world().add(eye, Camera{});
    play(eye, R"({"tracks": [{"target": "camera.yfov", "interpolation": "cubic",
                              "keys": [{"t": 0, "value": 3, "out": 50}, {"t": 1, "value": 3, "in": -50}]}]})");
    run(0.5);
    EXPECT_EQ(world().get<Camera>(eye).yfov, 3.13f);
}

TEST_F(TimelineTest, RepeatAndSpeedSayWhereItIs) {
    const Entity fox = add("Fox");
    const Entity player = play(walk);
    const auto x = [&] { return place(fox).translation.x; };
    timeline(player).repeat = Repeat::loop;
    run(2.5);
    EXPECT_NEAR(x(), 1.0, 1e-6);
    timeline(player).speed = 2.0f;
    run(0.25);
    EXPECT_NEAR(x(), 2.0, 1e-6);
    timeline(player).speed = -1.0f;
    run(0.25);
    EXPECT_NEAR(x(), 1.5, 1e-6) << "it turns round where it is";
    timeline(player) = {.speed = 1.0f, .time = 3.0, .repeat = Repeat::ping_pong, .document = timeline(player).document};
    run(0.5);
    EXPECT_NEAR(x(), 1.0, 1e-6) << "3.5 s, on the way back";
}

TEST_F(TimelineTest, PausedOrOverItChangesNothing) {
    const Entity fox = add("Fox");
    const Entity player = play(walk);
    run(0.5);
    timeline(player).playing = false;
    run(0.1);
    const Tick moved = world().changed_tick<Transform>(fox), played = world().changed_tick<Timeline>(player);
    run(0.1, 3);
    EXPECT_EQ(world().changed_tick<Transform>(fox), moved);
    EXPECT_EQ(world().changed_tick<Timeline>(player), played);
    EXPECT_EQ(counts().tracks, 0u);
    timeline(player).playing = true;
    run(9.0);
    const Tick end = world().changed_tick<Transform>(fox), last = world().changed_tick<Timeline>(player);
    run(0.1, 3);
    EXPECT_EQ(world().changed_tick<Transform>(fox), end);
    EXPECT_EQ(world().changed_tick<Timeline>(player), last);
}

TEST_F(TimelineTest, WhatHasItsValueIsNotMarkedAsChanged) {
    const Entity fox = add("Fox");
    play(R"({"duration": 9, "tracks": [{"target": "Fox/transform.translation", "keys": [[0, [1,2,3]]]}]})");
    run(0.1);
    const Tick moved = world().changed_tick<Transform>(fox);
    run(0.1, 5);
    EXPECT_EQ(world().changed_tick<Transform>(fox), moved);
    EXPECT_EQ(counts().tracks, 1u);
    EXPECT_EQ(counts().written, 0u);
}

const char* const busy = R"({"repeat": "ping_pong", "tracks": [
    {"target": "Fox/transform.translation", "interpolation": "cubic",
     "keys": [[0, [0,0,0]], [0.7, [1,3,0]], [1.1, [2,-1,5]], [3, [0,0,1]]]},
    {"target": "Fox/transform.rotation", "keys": [[0, [0,0,0,1]], [1, [0.6,0,0.8,0]], [2.5, [0,0.8,0,0.6]]]},
    {"target": "Ship/Mast/transform.scale", "interpolation": "ease_in_out", "keys": [[0.3, [1,1,1]], [2, [2,3,4]]]}],
  "paths": [{"target": "Eye", "look_at": "Ship/Mast", "points": [[0, [5,5,5]], [1, [0,6,5]], [2.2, [-5,5,4]]]}]})";

/// The bits of all transforms.
struct BusyScene : TimelineScene {
    BusyScene() {
        fox = add("Fox");
        const Entity ship = add("Ship");
        mast = add("Mast", ship);
        world().get_mutable<Transform>(ship).translation = {1, 2, 3};
        eye = add("Eye");
        player = play(busy);
    }
    std::string bits() {
        std::string result;
        for (const Entity entity : {fox, mast, eye})
            result.append(reinterpret_cast<const char*>(&place(entity)), sizeof(Transform));
        return result;
    }
    Entity fox, mast, eye, player;
};

TEST(TimelineBits, AJumpGivesWhatStepsGive) {
    BusyScene stepped;
    for (int frame = 0; frame < 400; ++frame) {
        stepped.run(1.0 / 60.0);
        if (frame % 41 != 0) continue;
        BusyScene jumped;
        jumped.timeline(jumped.player).time = stepped.timeline(stepped.player).time;
        jumped.run(0.0);
        EXPECT_EQ(jumped.bits(), stepped.bits()) << frame;
    }
}

TEST(TimelineBits, ThreadsChangeNothing) {
    const int threads = thread_limit();
    BusyScene one, many;
    for (int frame = 0; frame < 60; ++frame) {
        set_thread_limit(1);
        one.run(1.0 / 60.0);
        set_thread_limit(8);
        many.run(1.0 / 60.0);
        EXPECT_EQ(one.bits(), many.bits()) << frame;
    }
    set_thread_limit(threads);
}

TEST_F(TimelineTest, PathsPassTheirPointsAndLookWhereTheyAreTold) {
    const Entity fox = add("Fox"), rig = add("Rig"), eye = add("Eye", rig);
    world().get_mutable<Transform>(fox).translation = {10, 0, 0};
    world().get_mutable<Transform>(rig) = {{0, 1, 0}, glm::angleAxis(0.5f, glm::vec3(0, 1, 0)), glm::vec3(2.0f)};
    play(R"({"paths": [{"target": "Eye", "look_at": "Fox", "points": [[0, [0,0,0]], [1, [0,0,5]], [3, [1,0,5]]]}]})");
    run(1.0);
    EXPECT_EQ(place(eye).translation, glm::vec3(0, 0, 5));
    run(0.7);
    const glm::mat4 to_world = world().get<WorldTransform>(eye).matrix;
    const glm::vec3 forward = -glm::normalize(glm::vec3(to_world[2]));
    const glm::vec3 wanted = glm::normalize(glm::vec3(10, 0, 0) - glm::vec3(to_world[3]));
    EXPECT_NEAR(glm::dot(forward, wanted), 1.0f, 1e-5f);
    EXPECT_GT(to_world[1].y, 0.0f) << "upright";
    run(5.0);
    world().get_mutable<Transform>(fox).translation = {0, 50, 0};
    run(0.1);
    EXPECT_GT(-world().get<WorldTransform>(eye).matrix[2].y, 0.5f) << "it looks on when its way is over";
}

TEST_F(TimelineTest, LookingStraightDownIsATurnToo) {
    const Entity eye = add("Eye");
    play(eye, R"({"paths": [{"target": "", "look_at": [0, -7, 0]}]})");
    run(0.1);
    EXPECT_LT(glm::length(place(eye).rotation * glm::vec3(0, 0, -1) - glm::vec3(0, -1, 0)), 1e-6f);
}

TEST_F(TimelineTest, TargetsAreFoundAgainWhenNamesAndTheTreeChange) {
    const Entity first = add("Fox");
    const Entity player = play(R"({"duration": 100, "tracks":
        [{"target": "Den/Fox/transform.translation.x", "keys": [[0, 0], [100, 100]]}]})");
    run(1.0);
    EXPECT_EQ(place(first).translation.x, 0.0f) << "not in the den";
    const Entity den = add("Den");
    world().set_parent(first, den);
    run(1.0);
    EXPECT_EQ(place(first).translation.x, 2.0f);
    world().get_mutable<Name>(den).text = "Pit";
    run(1.0);
    EXPECT_EQ(place(first).translation.x, 2.0f) << "the den has another name";
    world().get_mutable<Name>(den).text = "Den";
    run(1.0);
    EXPECT_EQ(place(first).translation.x, 4.0f);
    world().destroy(first);
    run(1.0);
    const Entity second = add("Fox", den);
    run(1.0);
    EXPECT_EQ(place(second).translation.x, 6.0f);
    world().destroy(player);
    run(1.0);
    EXPECT_EQ(place(second).translation.x, 6.0f);
}

TEST_F(TimelineTest, OthersThatComeAndGoCauseNoSearch) {
    add("Fox");
    play(walk);
    run(0.1);
    EXPECT_EQ(counts().searched, 1u);
    run(0.1, 2); // what was new in the first frame's own tick is looked at twice
    for (int i = 0; i < 5; ++i) {
        const Entity other = add("bird", add("tree"));
        run(0.1);
        EXPECT_EQ(counts().searched, 0u) << i;
        world().destroy(other);
    }
    add("Fox");
    run(0.1);
    EXPECT_EQ(counts().searched, 1u);
}

TEST_F(TimelineTest, EveryCopyMovesItsOwnParts) {
    const Entity prefab = add("windmill"), sails = add("sails", prefab);
    play(prefab, R"({"duration": 10, "tracks": [{"target": "sails/transform.scale.x", "keys": [[0, 0], [10, 10]]}]})");
    const Entity copy = world().instantiate(prefab);
    timeline(copy).time = 5.0;
    run(1.0);
    EXPECT_EQ(place(sails).scale.x, 1.0f);
    EXPECT_EQ(place(world().children(copy)[0]).scale.x, 6.0f);
}

TEST_F(TimelineTest, AFieldOfATimelineCanBeMovedByAnother) {
    const Entity fox = add("Fox");
    const Entity player = play(add("player"), walk);
    timeline(player).playing = false;
    play(R"({"tracks": [{"target": "player/timeline.time", "interpolation": "ease_in", "keys": [[0, 0], [2, 2]]}]})");
    run(1.0, 2);
    run(0.0);
    EXPECT_EQ(timeline(player).time, 2.0);
    EXPECT_EQ(place(fox).translation.x, 4.0f);
}

TEST_F(TimelineTest, WhatIsNotThereIsSaidOnceAndNoError) {
    add("Fox");
    play(R"({"duration": 9, "tracks": [
        {"target": "Nobody/transform.translation.x", "keys": [[0, 0], [9, 1]]},
        {"target": "Fox/timeline.speed", "keys": [[0, 0], [9, 1]]}]})");
    testing::internal::CaptureStderr();
    run(0.1, 5);
    EXPECT_EQ(testing::internal::GetCapturedStderr(),
              "hachure: warning: timeline: there is no entity 'Nobody'\n"
              "hachure: warning: timeline: 'Fox' has no component 'timeline'\n");
}

} // namespace
} // namespace hachure::test
