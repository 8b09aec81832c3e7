#include <hachure/components/camera.h>
#include <hachure/components/light.h>
#include <hachure/runtime/error.h>
#include <hachure/tests/systems/timeline/timeline_scene.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <fstream>

namespace hachure::test {
namespace {

using nlohmann::json;
using testing::ElementsAre;
using testing::HasSubstr;

struct TimelinePartTest : ::testing::Test, TimelineScene {
    TimelinePartTest() {
        app.add_component<Camera>();
        app.add_component<Light>();
    }

    /// What is wrong with a timeline; empty when nothing is.
    std::string fault(const std::string& text) {
        try {
            play(text);
        } catch (const Error& error) {
            return error.what();
        }
        return {};
    }
    std::string track_fault(const std::string& target, const std::string& keys, const std::string& more = "") {
        return fault(R"({"tracks": [{"target": ")" + target + R"(", "keys": )" + keys + more + "}]}");
    }
    json written(Entity entity) { return part().write(world(), entity).value(); }
};

TEST_F(TimelinePartTest, FaultsNameLineAndColumn) {
    EXPECT_EQ(
        fault("{\"tracks\": [\n  {\"target\": \"Fox/transform.translation\",\n   \"keys\": [[0, [0,0,0]], [1, 7]]}]}"),
        "test.scene.json: these are not 3 numbers (line 3, column 31: /tracks/0/keys/1/1)");
    EXPECT_EQ(fault("{\n\"trakcs\": []}"),
              "test.scene.json: there is no key \"trakcs\" here, but hachure_timeline, doc, "
              "duration, repeat, speed, playing, time, tracks, actions, paths (line 2, "
              "column 11: /trakcs)");
}

TEST_F(TimelinePartTest, TargetsMustExist) {
    EXPECT_THAT(track_fault("Fox", "[[0, 1]]"), HasSubstr("\"Fox\" names no field"));
    EXPECT_THAT(track_fault("Fox/trasnform.scale", "[[0, 1]]"), HasSubstr("there is no component \"trasnform\""));
    EXPECT_THAT(track_fault("transform.size", "[[0, 1]]"), HasSubstr("\"transform\" has no field \"size\""));
    EXPECT_THAT(track_fault("transform.scale.w", "[[0, 1]]"), HasSubstr("has no element \"w\""));
    EXPECT_THAT(track_fault("transform.scale.", "[[0, 1]]"), HasSubstr("has no element \"\""));
    EXPECT_THAT(track_fault("transform.rotation.x", "[[0, 1]]"), HasSubstr("one by one"));
    EXPECT_THAT(track_fault("camera.active.x", "[[0, true]]"), HasSubstr("has no element"));
    EXPECT_EQ(track_fault("a.b/c/transform.scale.z", "[[0, 1]]"), "") << "names of entities may have dots";
}

TEST_F(TimelinePartTest, KeysMustBeInOrderAndFinite) {
    const std::string x = "transform.scale.x";
    EXPECT_THAT(track_fault(x, "[[1, 0], [1, 1]]"), HasSubstr("the key at 1 s does not come after the one at 1 s"));
    EXPECT_THAT(track_fault(x, "[[2, 0], [1, 1]]"), HasSubstr("does not come after"));
    EXPECT_THAT(track_fault(x, "[[-1, 0]]"), HasSubstr("outside [0, 1000000000]"));
    EXPECT_THAT(track_fault(x, "[[1e400, 0]]"), HasSubstr("test.scene.json"));
    EXPECT_THAT(track_fault(x, "[[1, 1e39]]"), HasSubstr("not finite"));
    EXPECT_THAT(track_fault(x, "[[\"1\", 0]]"), HasSubstr("no number"));
    EXPECT_THAT(track_fault(x, "[]"), HasSubstr("at least one key"));
    EXPECT_THAT(track_fault(x, "{}"), HasSubstr("no array"));
    EXPECT_THAT(track_fault(x, "[[1]]"), HasSubstr("a key is [time, value]"));
    EXPECT_THAT(track_fault(x, "[{\"t\": 1}]"), HasSubstr("\"value\" is missing"));
    EXPECT_THAT(track_fault(x, "[{\"t\": 1, \"value\": 1, \"vlaue\": 2}]"), HasSubstr("no key \"vlaue\""));
}

TEST_F(TimelinePartTest, ValuesMustFitTheirField) {
    EXPECT_THAT(track_fault("camera.yfov", "[[0, 4]]"), HasSubstr("camera.yfov: 4 is outside [0.001, 3.13]"));
    EXPECT_THAT(track_fault("camera.active", "[[0, 1]]"), HasSubstr("neither true nor false"));
    EXPECT_THAT(track_fault("camera.projection", "[[0, \"flat\"]]"), HasSubstr("none of perspective, orthographic"));
    EXPECT_THAT(track_fault("transform.rotation", "[[0, [1,1,1,1]]]"), HasSubstr("length 1"));
    EXPECT_THAT(track_fault("transform.scale", "[[0, [1,1]]]"), HasSubstr("not 3 numbers"));
    EXPECT_THAT(track_fault("transform.scale", "[[0, [1,1,\"1\"]]]"), HasSubstr("no number"));
    EXPECT_THAT(track_fault("light.color", "[[0, \"#ff\"]]"), HasSubstr("light.color"));
    EXPECT_EQ(track_fault("light.color", "[[0, \"#ff8800\"], [1, [0, 0.5, 1]]]"), "");
    EXPECT_EQ(track_fault("light.color.g", "[[0, 0.5]]"), "");
}

TEST_F(TimelinePartTest, InterpolationMustFitTheKind) {
    EXPECT_THAT(track_fault("camera.active", "[[0, true]]", R"(, "interpolation": "linear")"),
                HasSubstr("a value of kind boolean changes in steps, not linear"));
    EXPECT_THAT(track_fault("camera.active", R"([{"t": 0, "value": true, "interpolation": "cubic"}])"),
                HasSubstr("changes in steps"));
    EXPECT_EQ(track_fault("camera.active", "[[0, true]]", R"(, "interpolation": "step")"), "");
    EXPECT_THAT(track_fault("transform.scale.x", "[[0, 1]]", R"(, "interpolation": "smooth")"),
                HasSubstr("\"smooth\" is none of step, linear, cubic"));
    EXPECT_THAT(track_fault("transform.scale.x", R"([{"t": 0, "value": 1, "in": 1}])"),
                HasSubstr("tangents are for cubic interpolation"));
    EXPECT_THAT(track_fault("transform.scale", R"([{"t": 0, "value": [1,1,1], "in": 1, "interpolation": "cubic"}])"),
                HasSubstr("not 3 numbers"));
}

TEST_F(TimelinePartTest, NothingIsMovedTwice) {
    EXPECT_THAT(fault(R"({"tracks": [{"target": "a/transform.scale", "keys": [[0, [1,1,1]]]},
                                     {"target": "a/transform.scale", "keys": [[0, [2,1,1]]]}]})"),
                HasSubstr("two tracks move \"a/transform.scale\""));
    EXPECT_THAT(fault(R"({"tracks": [{"target": "a/transform.translation", "keys": [[0, [1,1,1]]]}],
                          "paths": [{"target": "a", "points": [[0, [1,1,1]]]}]})"),
                HasSubstr("a track or another path moves transform.translation"));
}

TEST_F(TimelinePartTest, PathsAndActionsAreChecked) {
    EXPECT_THAT(fault(R"({"paths": [{"target": "a"}]})"), HasSubstr("a path has points"));
    EXPECT_THAT(fault(R"({"paths": [{"target": "a", "points": []}]})"), HasSubstr("at least one point"));
    EXPECT_THAT(fault(R"({"paths": [{"target": "a", "points": [[1, [0,0,0]], [0, [0,0,0]]]}]})"),
                HasSubstr("the point at 0 s does not come after the one at 1 s"));
    EXPECT_THAT(fault(R"({"paths": [{"target": "a", "points": [[1, [0,0]]]}]})"), HasSubstr("[x, y, z]"));
    EXPECT_THAT(fault(R"({"actions": [{"at": 1, "evnet": "a"}]})"), HasSubstr("an action has one of spawn"));
    EXPECT_THAT(fault(R"({"actions": [{"at": 1, "event": "a", "to": "b"}]})"), HasSubstr("no key \"to\""));
    EXPECT_THAT(fault(R"({"actions": [{"event": "a"}]})"), HasSubstr("\"at\" is missing"));
    EXPECT_THAT(fault(R"({"actions": [{"at": 1, "destroy": ""}]})"), HasSubstr("the name is empty"));
    EXPECT_THAT(fault(R"({"actions": [{"at": 1, "state": {"a": "b"}}]})"), HasSubstr("no number"));
    EXPECT_THAT(fault(R"({"duration": 1, "actions": [{"at": 2, "event": "a"}]})"), HasSubstr("behind the end"));
    EXPECT_THAT(fault(R"({"duration": -1})"), HasSubstr("outside"));
    EXPECT_THAT(fault(R"({"hachure_timeline": 2})"), HasSubstr("outside [1, 1]"));
    EXPECT_THAT(fault("[]"), HasSubstr("a timeline is an object"));
    EXPECT_EQ(fault(R"({"duration": 1, "tracks": [{"target": "transform.scale.x", "keys": [[2, 1]]}]})"), "");
    EXPECT_THAT(warnings, ElementsAre("test.scene.json: keys behind the end, up to 2 s, are never reached (line 1, "
                                      "column 14: /duration)"));
}

TEST_F(TimelinePartTest, WhatWasReadIsWrittenAsItWas) {
    const std::string text = R"({"doc": "a walk", "duration": 10, "speed": 0.5, "tracks": [
        {"target": "Fox/transform.translation", "interpolation": "cubic",
         "keys": [[0, [0,0,0]], {"t": 1, "value": [1,0,0], "out": [0,1,0]}]}],
        "actions": [{"at": 3, "event": "there"}]})";
    const Entity entity = play(text);
    EXPECT_EQ(written(entity), json::parse(text));
    timeline(entity).speed = 0.1f;
    timeline(entity).time = 3.0;
    timeline(entity).repeat = Repeat::ping_pong;
    json changed = json::parse(text);
    changed["speed"] = 0.1;
    changed["time"] = 3.0;
    changed["repeat"] = "ping_pong";
    EXPECT_EQ(written(entity), changed);
    const Entity again = play(changed.dump());
    EXPECT_EQ(timeline(again).time, 3.0);
    EXPECT_EQ(timeline(again).speed, 0.1f);
    EXPECT_EQ(written(again), changed);
    EXPECT_FALSE(part().write(world(), world().create()));
    EXPECT_EQ(written(world().create_with(Timeline{})), json::object());
}

TEST_F(TimelinePartTest, AFileOfItsOwn) {
    const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "timeline_part";
    std::filesystem::create_directories(folder);
    std::ofstream(folder / "x.timeline.json") << R"({"hachure_timeline": 1, "speed": 2, "duration": 4})";
    std::ofstream(folder / "bad.timeline.json") << "{\n \"sped\": 2}";
    const std::string text = R"({"file": "x.timeline.json", "repeat": "loop"})";
    const Entity entity = play(world().create(), text, folder);
    EXPECT_EQ(timeline(entity).speed, 2.0f);
    EXPECT_EQ(timeline(entity).repeat, Repeat::loop);
    EXPECT_EQ(timeline(entity).document->duration, 4.0);
    EXPECT_EQ(written(entity), json::parse(text));
    const auto fault_in = [&](const char* value) {
        try {
            play(world().create(), value, folder);
        } catch (const Error& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    EXPECT_THAT(fault_in(R"({"file": "bad.timeline.json"})"), HasSubstr("bad.timeline.json: there is no key \"sped\""));
    EXPECT_THAT(fault_in(R"({"file": "../x.timeline.json"})"), HasSubstr("is no file in the folder of this one"));
    EXPECT_THAT(fault_in(R"({"file": "/etc/passwd"})"), HasSubstr("(line 1, column 10: /file)"));
    EXPECT_THAT(fault_in(R"({"file": "none.json"})"), HasSubstr("none.json"));
    EXPECT_THAT(fault_in(R"({"file": "x.timeline.json", "tracks": []})"), HasSubstr("no key \"tracks\""));
}

TEST_F(TimelinePartTest, TheSchemaKnowsEveryKey) {
    const json& properties = part().schema.at("properties");
    for (const char* key : {"file", "hachure_timeline", "doc", "duration", "repeat", "speed", "playing", "time",
                            "tracks", "actions", "paths"})
        EXPECT_TRUE(properties.contains(key)) << key;
    EXPECT_EQ(properties.size(), 11u);
}

} // namespace
} // namespace hachure::test
