#include <hachure/components/animation_events.h>
#include <hachure/components/animation_layers.h>
#include <hachure/components/animation_states.h>
#include <hachure/runtime/app/app.h>
#include <hachure/runtime/assets/json_text.h>
#include <hachure/runtime/error.h>
#include <hachure/runtime/scene/scene_parts.h>
#include <hachure/systems/animation/animation.h>
#include <hachure/systems/model/spawn_model.h>
#include <hachure/systems/transform/transform.h>
#include <hachure/tests/support/arm_model.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace hachure::test {
namespace {

using nlohmann::json;
using testing::ElementsAre;
using testing::HasSubstr;

struct AnimationPartsTest : ::testing::Test {
    AnimationPartsTest() {
        register_transform(app);
        register_animation(app);
        root = spawn_model(app.world(), arm_model()).root;
    }

    World& world() { return app.world(); }
    const ScenePart& part(const char* name) { return *world().resource<SceneParts>().find(name); }
    void read(const char* name, Entity entity, const std::string& text) {
        const assets::JsonText document = assets::JsonText::parse("test.scene.json", text);
        part(name).read(world(), entity, {document, "", document.root(), app.types(), {}, warnings});
    }
    std::string fault(const char* name, const std::string& text) {
        try {
            read(name, root, text);
        } catch (const Error& error) {
            return error.what();
        }
        return {};
    }
    json written(const char* name) { return part(name).write(world(), root).value(); }

    App app;
    Entity root;
    std::vector<std::string> warnings;
};

const char* const machine = R"({
    "parameters": {"go": "trigger", "high": false, "speed": 0.25},
    "states": [{"name": "rest"}, {"name": "walk", "clip": "walk", "repeat": "once", "speed": 2}],
    "transitions": [
      {"from": "rest", "to": "walk", "when": [{"parameter": "speed", "greater": 1}, {"parameter": "high", "set": false}],
       "fade": 0, "after": 0.5},
      {"to": "rest", "when": [{"parameter": "go", "set": true}], "to_itself": false}]})";

TEST_F(AnimationPartsTest, AStateMachineIsReadByNames) {
    read("animation_states", root, machine);
    const AnimationStates& states = world().get<AnimationStates>(root);
    ASSERT_EQ(states.machine.states.size(), 2u);
    EXPECT_EQ(states.machine.states[1].clip, 1);
    EXPECT_EQ(states.machine.states[1].playback.duration, 1.0);
    EXPECT_EQ(states.machine.transitions[0].exit_time, 0.5);
    EXPECT_EQ(states.machine.transitions[1].from, animation::any_state);
    EXPECT_THAT(states.parameters, ElementsAre(0.0f, 0.0f, 0.25f));
    world().get_mutable<AnimationStates>(root).parameters[2] = 2.0f;
    for (int i = 0; i < 4; ++i) app.run_frame(0.25);
    EXPECT_EQ(world().get<AnimationStates>(root).state.current(), 1u) << "it steers what is played";
}

TEST_F(AnimationPartsTest, WhatWasReadIsWrittenAsItWas) {
    read("animation_states", root, machine);
    EXPECT_EQ(written("animation_states"), json::parse(machine)) << "also what says the usual";
    world().get_mutable<AnimationStates>(root).parameters[2] = 1.5f;
    const json changed = written("animation_states");
    EXPECT_EQ(changed["values"], json::parse(R"({"speed": 1.5})"));
    EXPECT_EQ(changed["states"], json::parse(machine)["states"]);
    read("animation_states", root, changed.dump());
    EXPECT_EQ(world().get<AnimationStates>(root).parameters[2], 1.5f);
    EXPECT_EQ(written("animation_states"), changed);
    const char* const layers = R"([{"clip": "bend", "weight": 0.5, "speed": 1}, {"clip": "swell", "mask": "elbow",
                                    "additive": true, "repeat": "once", "offset": 0.1, "time": 0.5}])";
    read("animation_layers", root, layers);
    EXPECT_EQ(written("animation_layers"), json::parse(layers));
    const char* const events = R"({"bend": [[0.75, "late"], [0.25, "early"]], "walk": []})";
    read("animation_events", root, events);
    EXPECT_EQ(written("animation_events"), json::parse(events));
    EXPECT_TRUE(warnings.empty());
    const Entity none = world().create();
    for (const char* name : {"animation_states", "animation_layers", "animation_events"})
        EXPECT_FALSE(part(name).write(world(), none)) << name;
}

TEST_F(AnimationPartsTest, LayersAreRead) {
    read("animation_layers", root, R"([{"clip": "bend", "weight": 0.5, "repeat": "ping_pong"}, {"clip": "nope"}])");
    const AnimationLayers& layers = world().get<AnimationLayers>(root);
    ASSERT_EQ(layers.layers.size(), 2u);
    EXPECT_EQ(layers.layers[0].weight, 0.5f);
    EXPECT_EQ(layers.layers[0].repeat, Repeat::ping_pong);
    EXPECT_THAT(warnings, ElementsAre(HasSubstr("test.scene.json: the model has no clip \"nope\" (line 1, column 67")));
    world().get_mutable<AnimationLayers>(root).layers[1].clip = "swell";
    EXPECT_EQ(written("animation_layers"),
              json::parse(R"([{"clip": "bend", "weight": 0.5, "repeat": "ping_pong"}, {"clip": "swell"}])"));
}

TEST_F(AnimationPartsTest, EventsAreSortedAndKeptInTheirClips) {
    read("animation_events", root, R"({"bend": [[3, "late"], [0.25, "early"]], "nope": [[5, "never"]]})");
    const AnimationEvents& events = world().get<AnimationEvents>(root);
    EXPECT_EQ(events.by_clip.at("bend")[0].name, "early");
    EXPECT_EQ(events.by_clip.at("bend")[1].time, 1.0);
    EXPECT_EQ(events.by_clip.at("nope")[0].time, 5.0);
    EXPECT_THAT(warnings, ElementsAre(HasSubstr("event 'late' lies outside of its clip and is moved (line 1"),
                                      HasSubstr("no clip \"nope\"")));
}

TEST_F(AnimationPartsTest, FaultsNameTheirPlace) {
    const auto states = [&](const std::string& more) {
        return fault("animation_states", R"({"states": [{"name": "a"}])" + more + "}");
    };
    EXPECT_EQ(states(R"(, "transitions": [{"to": "b"}])"),
              "test.scene.json: there is no state \"b\" (line 1, column 52: /transitions/0/to)");
    EXPECT_THAT(states(R"(, "transitions": [{"from": "a"}])"), HasSubstr("\"to\" is missing"));
    EXPECT_THAT(states(R"(, "transitions": [{"to": "a", "when": [{"parameter": "x", "set": true}]}])"),
                HasSubstr("there is no parameter \"x\""));
    EXPECT_THAT(states(R"(, "parameters": {"x": 1}, "transitions": [{"to": "a", "when": [{"parameter": "x"}]}])"),
                HasSubstr("compares its parameter once"));
    EXPECT_THAT(states(R"(, "parameters": {"x": "tigger"})"), HasSubstr("none of trigger"));
    EXPECT_THAT(states(R"(, "values": {"x": 1})"), HasSubstr("no parameter \"x\""));
    EXPECT_THAT(states(R"(, "start": "a")"), HasSubstr("no key \"start\""));
    EXPECT_THAT(fault("animation_states", R"({"states": []})"), HasSubstr("it has no states"));
    EXPECT_THAT(fault("animation_states", R"({"states": [{"name": "a"}, {"name": "a"}]})"),
                HasSubstr("two states have the name 'a'"));
    EXPECT_THAT(fault("animation_states", R"({"states": [{"name": "a", "clip": "fly"}]})"),
                HasSubstr("the model has no clip \"fly\""));
    EXPECT_THAT(fault("animation_layers", R"([{"clip": "bend", "weight": 2}])"), HasSubstr("2 is outside [0, 1]"));
    EXPECT_THAT(fault("animation_layers", R"([{"weight": 1}])"), HasSubstr("\"clip\" is missing"));
    EXPECT_THAT(fault("animation_events", R"({"bend": [[1]]})"), HasSubstr("an event is [time, name]"));
    EXPECT_THAT(fault("animation_events", R"({"bend": [[1, ""]]})"), HasSubstr("(line 1, column 15: /bend/0/1)"));
    EXPECT_THROW(read("animation_states", world().create(), machine), Error) << "no model here";
}

} // namespace
} // namespace hachure::test
