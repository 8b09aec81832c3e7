#include <hachure/components/animation.h>
#include <hachure/components/animation_events.h>
#include <hachure/components/animation_layers.h>
#include <hachure/components/animation_states.h>
#include <hachure/components/camera.h>
#include <hachure/components/light.h>
#include <hachure/components/morph_weights.h>
#include <hachure/components/rig.h>
#include <hachure/components/root_motion.h>
#include <hachure/components/surface.h>
#include <hachure/components/transform.h>
#include <hachure/runtime/app/app.h>
#include <hachure/runtime/ecs/events.h>
#include <hachure/systems/animation/animation.h>
#include <hachure/systems/deform/deform.h>
#include <hachure/systems/model/spawn_model.h>
#include <hachure/systems/transform/transform.h>
#include <hachure/tests/support/arm_model.h>

#include <gtest/gtest.h>

namespace hachure::test {
namespace {

struct AnimationTest : ::testing::Test {
    AnimationTest() {
        register_transform(app);
        register_animation(app);
        register_deform(app);
        model = spawn_model(app.world(), arm_model());
    }

    World& world() { return app.world(); }
    Entity node(std::size_t index) { return world().get<Rig>(model.root).nodes[index]; }
    Animation& play(const char* clip) { return world().add(model.root, Animation{.clip = clip}); }
    Animation& animation() { return world().get_mutable<Animation>(model.root); }
    const AnimationCounts& counts() { return world().resource<AnimationCounts>(); }

    /// Degrees that the elbow is bent by.
    double bend(Entity root = Entity::null) {
        const Rig& rig = world().get<Rig>(root ? root : model.root);
        const glm::dquat turn(world().get<Transform>(rig.nodes[2]).rotation);
        return glm::degrees(2.0 * std::atan2(turn.z, turn.w));
    }
    double shoulder() { return world().get<Transform>(node(1)).translation.x; }

    App app;
    SpawnedModel model;
};

TEST_F(AnimationTest, ClipsOfTheFileAreNamed) {
    EXPECT_EQ(model.clips, (std::vector<std::string>{"bend", "walk", "swell"}));
    EXPECT_TRUE(model.warnings.empty());
}

TEST_F(AnimationTest, APlayingClipMovesItsNodes) {
    play("bend");
    for (const double time : {0.0, 0.25, 0.25, 0.4}) app.run_frame(time);
    EXPECT_NEAR(bend(), 81.0, 1e-4);
    EXPECT_NEAR(animation().time, 0.9, 1e-12);
    app.run_frame(0.6);
    EXPECT_NEAR(bend(), 45.0, 1e-4) << "half way through the second round";
}

TEST_F(AnimationTest, SpeedOffsetAndRepeatSayWhereTheClipIs) {
    play("bend") = {.clip = "bend", .repeat = Repeat::ping_pong, .speed = 2.0f, .offset = 0.25f};
    app.run_frame(0.5);
    EXPECT_NEAR(bend(), 67.5, 1e-4) << "1.25 s, on the way back";
    animation().speed = 0.5f;
    app.run_frame(0.5);
    EXPECT_NEAR(bend(), 45.0, 1e-4) << "another speed goes on from where the clip is";
    animation() = {.clip = "bend", .repeat = Repeat::once, .speed = -1.0f};
    app.run_frame(0.25);
    EXPECT_NEAR(bend(), 67.5, 1e-4) << "backwards begins at the end";
}

TEST_F(AnimationTest, APausedModelCostsNothing) {
    play("bend");
    app.run_frame(0.25);
    EXPECT_EQ(counts().models, 1u);
    EXPECT_EQ(counts().clips, 1u);
    animation().playing = false;
    app.run_frame(0.25);
    const Tick before = world().changed_tick<Transform>(node(2));
    app.run_frame(0.25);
    EXPECT_EQ(counts().models, 0u);
    EXPECT_EQ(world().changed_tick<Transform>(node(2)), before);
    EXPECT_NEAR(bend(), 22.5, 1e-4);
    animation().playing = true;
    app.run_frame(0.25);
    EXPECT_NEAR(bend(), 45.0, 1e-4);
}

TEST_F(AnimationTest, AClipThatIsOverCostsNothing) {
    play("bend").repeat = Repeat::once;
    app.run_frame(2.0);
    EXPECT_NEAR(bend(), 90.0, 1e-4);
    app.run_frame(0.1);
    EXPECT_EQ(counts().models, 0u);
}

TEST_F(AnimationTest, AChangeOfClipFades) {
    play("bend") = {.clip = "bend", .repeat = Repeat::once, .fade = 1.0f};
    app.run_frame(1.0);
    animation().clip = "walk";
    app.run_frame(0.5);
    EXPECT_NEAR(bend(), 45.0, 1e-3) << "half of what it was, half of the rest pose";
    EXPECT_NEAR(shoulder(), 0.5, 1e-5) << "half of 1 m";
    EXPECT_EQ(counts().clips, 2u);
    app.run_frame(0.5);
    EXPECT_NEAR(bend(), 0.0, 1e-4);
    EXPECT_EQ(counts().clips, 1u);
}

TEST_F(AnimationTest, AnUnknownClipShowsTheRestPose) {
    play("bend").fade = 0.0f;
    app.run_frame(0.5);
    animation().clip = "no such";
    app.run_frame(0.5);
    EXPECT_NEAR(bend(), 0.0, 1e-6);
}

TEST_F(AnimationTest, MorphWeightsArePlayed) {
    play("swell");
    app.run_frame(0.75);
    const Rig& rig = world().get<Rig>(model.root);
    EXPECT_FLOAT_EQ(world().get<MorphWeights>(rig.morphs[0]).values.at(0), 0.75f);
}

TEST_F(AnimationTest, LayersLieOverWhatPlays) {
    play("walk");
    world().add(model.root, AnimationLayers{{{.clip = "bend", .weight = 0.5f}}});
    app.run_frame(0.5);
    EXPECT_NEAR(shoulder(), 1.0, 1e-5) << "the layer's clip does not move it";
    EXPECT_NEAR(bend(), 22.5, 1e-3);
    world().get_mutable<AnimationLayers>(model.root).layers[0] = {.clip = "bend", .additive = true, .time = 0.5};
    app.run_frame(0.25);
    EXPECT_NEAR(bend(), 67.5, 1e-3);
    world().get_mutable<AnimationLayers>(model.root).layers[0] = {.clip = "bend", .mask = "shoulder", .time = 0.25};
    app.run_frame(0.0);
    EXPECT_NEAR(bend(), 22.5, 1e-3) << "the elbow is below the shoulder";
    world().get_mutable<AnimationLayers>(model.root).layers[0].mask = "arm";
    app.run_frame(0.0);
    EXPECT_NEAR(bend(), 0.0, 1e-3) << "and not below the mesh";
}

TEST_F(AnimationTest, StatesChooseWhatPlays) {
    animation::StateMachine machine;
    machine.parameters = {{.name = "go", .kind = animation::ParameterKind::flag}};
    machine.states = {{.name = "idle", .clip = 0, .playback = {.duration = 1.0}},
                      {.name = "walk", .clip = 1, .playback = {.duration = 1.0}}};
    machine.transitions = {{.from = 0, .to = 1, .conditions = {{.parameter = 0}}, .duration = 0.5}};
    world().add(model.root, AnimationStates::make(machine));
    app.run_frame(0.5);
    EXPECT_NEAR(bend(), 45.0, 1e-4);
    world().get_mutable<AnimationStates>(model.root).parameters[0] = 1.0f;
    app.run_frame(0.25);
    EXPECT_EQ(counts().clips, 2u);
    EXPECT_NEAR(shoulder(), 0.25, 1e-5) << "half of .5 m";
    app.run_frame(0.25);
    EXPECT_NEAR(bend(), 0.0, 1e-4);
    EXPECT_NEAR(shoulder(), 1.0, 1e-5);
}

TEST_F(AnimationTest, RootMotionMovesTheModel) {
    play("walk");
    world().add(model.root, RootMotion{.joint = "shoulder"});
    world().get_mutable<Transform>(model.root).rotation = glm::angleAxis(glm::half_pi<float>(), glm::vec3(0, 1, 0));
    for (int i = 0; i < 25; ++i) app.run_frame(0.1);
    EXPECT_NEAR(shoulder(), 0.0, 1e-5);
    const glm::vec3 place = world().get<Transform>(model.root).translation;
    EXPECT_NEAR(place.z, -5.0, 1e-4) << "two rounds and a half, turned to where it looks";
    EXPECT_NEAR(place.x, 0.0, 1e-4);
}

TEST_F(AnimationTest, EventsAreSentOnce) {
    play("walk");
    AnimationEvents events;
    events.by_clip["walk"] = {{0.0, "left"}, {0.5, "right"}};
    world().add(model.root, events);
    std::string steps;
    app.add_system(Stage::transform, "listen", [&steps, this](EventReader<ClipEvent> heard) {
        for (const ClipEvent& event : heard) {
            steps += event.name[0];
            EXPECT_EQ(event.model, model.root);
            EXPECT_EQ(event.clip, "walk");
        }
    });
    for (int i = 0; i < 23; ++i) app.run_frame(0.1);
    EXPECT_EQ(steps, "lrlrl");
}

TEST_F(AnimationTest, WhatIsPausedPassesNothingThoughLayersChange) {
    play("walk");
    world().add(model.root, RootMotion{.joint = "shoulder"});
    world().add(model.root, AnimationLayers{{{.clip = "bend", .weight = 0.5f}}});
    app.run_frame(0.5);
    animation().playing = false;
    app.run_frame(0.5);
    for (const float weight : {0.6f, 0.7f}) {
        world().get_mutable<AnimationLayers>(model.root).layers[0].weight = weight;
        app.run_frame(0.5);
        EXPECT_EQ(counts().models, 1u);
        EXPECT_NEAR(world().get<Transform>(model.root).translation.x, 1.0, 1e-5);
    }
}

TEST_F(AnimationTest, CopiesPlayOnTheirOwn) {
    play("bend");
    const Entity copy = world().instantiate(model.root);
    world().get_mutable<Animation>(copy).offset = 0.5f;
    app.run_frame(0.25);
    EXPECT_NEAR(bend(), 22.5, 1e-4);
    EXPECT_NEAR(bend(copy), 67.5, 1e-4);
    EXPECT_EQ(counts().models, 2u);
    world().destroy(copy);
    app.run_frame(0.25);
    EXPECT_EQ(counts().models, 1u);
}

TEST_F(AnimationTest, APoseDoesNotDependOnTheFramesBefore) {
    App other;
    register_transform(other);
    register_animation(other);
    const SpawnedModel second = spawn_model(other.world(), arm_model());
    other.world().add(second.root, Animation{.clip = "bend"});
    other.run_frame(37.0 / 30.0);
    play("bend");
    for (int i = 0; i < 37; ++i) app.run_frame(1.0 / 30.0);
    EXPECT_EQ(world().get<Transform>(node(2)).rotation,
              other.world().get<Transform>(other.world().get<Rig>(second.root).nodes[2]).rotation);
}

TEST_F(AnimationTest, PointersMoveCamerasLightsAndVisibility) {
    app.add_component<Camera>();
    app.add_component<Light>();
    app.add_component<Surface>();
    assets::Model lit = arm_model();
    lit.cameras.push_back({.name = "camera", .yfov = 0.5f});
    lit.lights.push_back({.name = "lamp"});
    lit.nodes[1].camera = 0;
    lit.nodes[2].light = 0;
    const auto pointer = [](const char* text, std::vector<float> values) {
        assets::AnimationChannel result = channel(-1, assets::AnimationPath::pointer, {0, 1}, std::move(values));
        result.pointer = text;
        return result;
    };
    lit.animations = {
        {"look",
         {pointer("/cameras/0/perspective/yfov", {0.5f, 1.5f}),
          pointer("/extensions/KHR_lights_punctual/lights/0/color", {1, 1, 1, 0, 0.5f, 1}),
          pointer("/nodes/0/extensions/KHR_node_visibility/visible", {0, 0}), pointer("/materials/0/nothing", {0, 1})},
         1.0f}};
    const SpawnedModel spawned = spawn_model(world(), lit);
    ASSERT_EQ(spawned.warnings.size(), 1u);
    EXPECT_NE(spawned.warnings[0].find("/materials/0/nothing"), std::string::npos);
    world().add(spawned.root, Animation{.clip = "look"});
    app.run_frame(0.5);
    EXPECT_FLOAT_EQ(world().get<Camera>(spawned.cameras[0]).yfov, 1.0f);
    EXPECT_EQ(world().get<Light>(spawned.lights[0]).color, glm::vec3(0.5f, 0.75f, 1.0f));
    EXPECT_FALSE(world().get<Surface>(spawned.surfaces[0]).visible);
}

} // namespace
} // namespace hachure::test
