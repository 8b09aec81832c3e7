// Whatever stands in a file: it is read, or refused with a place, and what is read plays.

#include <hachure/components/camera.h>
#include <hachure/runtime/error.h>
#include <hachure/tests/systems/timeline/timeline_scene.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <random>

namespace hachure::test {
namespace {

using nlohmann::json;

const char* const whole = R"({
  "duration": 4, "repeat": "ping_pong", "speed": -1.5, "playing": true, "time": 0.5,
  "tracks": [
    {"target": "Fox/transform.translation", "interpolation": "cubic",
     "keys": [[0, [0, 0, 0]], {"t": 1, "value": [1, 2, 3], "in": [0, 0, 1], "out": [9, 0, 0]}, [3, [0, 0, 4]]]},
    {"target": "Fox/transform.rotation", "interpolation": "ease_in", "keys": [[0, [0, 0, 0, 1]], [2, [0, 1, 0, 0]]]},
    {"target": "Fox/camera.active", "keys": [[0, true], [1, false]]},
    {"target": "Fox/camera.projection", "keys": [[0, "perspective"], [1, "orthographic"]]},
    {"target": "Eye/camera.yfov", "keys": [[0, 0.5], [1, 1.5]]},
    {"target": "Eye/transform.scale.y", "keys": [[0, 0.5], [1, 1.5]]}],
  "paths": [{"target": "Eye", "look_at": "Fox", "points": [[0, [0, 0, 5]], [1, [1, 0, 5]], [3, [1, 0, 5]]]}],
  "actions": [{"at": 1, "event": "one", "on": "Fox"}, {"at": 1, "camera": "Eye"}, {"at": 2, "destroy": "Post"},
              {"at": 3, "parent": "Fox", "to": "Eye"}, {"at": 3, "state": {"a": 1}, "on": "Fox"}]})";

const std::vector<json>& oddities() {
    static const std::vector<json> values{nullptr,
                                          true,
                                          -1,
                                          0,
                                          0.25,
                                          2,
                                          1e300,
                                          -1e300,
                                          18446744073709551615u,
                                          "",
                                          "Fox",
                                          "Eye/transform.scale",
                                          "loop",
                                          "cubic",
                                          "step",
                                          "/.",
                                          "a.b.c.d",
                                          json::array(),
                                          json::object(),
                                          json::array({0, 1}),
                                          json::array({1, 2, 3}),
                                          json::array({0, 0, 0, 0}),
                                          json::array({0, json::array({1e38, 1e38, 1e38})}),
                                          json{{"t", 1}, {"value", 2}}};
    return values;
}

TEST(TimelineFuzz, WhatIsReadPlays) {
    std::mt19937 random(3);
    const json original = json::parse(whole);
    const json flat = original.flatten();
    std::vector<json::json_pointer> places;
    for (const auto& [pointer, value] : flat.items())
        for (json::json_pointer at(pointer); !at.empty(); at = at.parent_pointer()) places.push_back(at);
    int read = 0, refused = 0;
    for (int round = 0; round < 1500; ++round) {
        json changed = original;
        for (int i = round % 3; i >= 0; --i) {
            const json::json_pointer& at = places[random() % places.size()];
            if (!changed.contains(at)) continue;
            if (random() % 4 == 0 && changed[at.parent_pointer()].is_object())
                changed[at.parent_pointer()].erase(at.back());
            else
                changed[at] = oddities()[random() % oddities().size()];
        }
        TimelineScene scene;
        scene.app.add_component<Camera>();
        const Entity fox = scene.add("Fox"), eye = scene.add("Eye");
        scene.add("Post");
        scene.world().add(fox, Camera{});
        scene.world().add(eye, Camera{});
        testing::internal::CaptureStderr();
        try {
            scene.play(changed.dump());
            ++read;
            for (const double step : {0.0, 0.3, 0.3, 17.0, 0.1}) scene.run(step);
        } catch (const Error& error) {
            ++refused;
            EXPECT_NE(std::string(error.what()).find("(line 1, column "), std::string::npos) << error.what();
        }
        testing::internal::GetCapturedStderr();
        for (const Entity entity : {fox, eye})
            EXPECT_TRUE(std::isfinite(glm::dot(scene.place(entity).rotation, scene.place(entity).rotation)) &&
                        std::isfinite(scene.place(entity).translation.x))
                << changed;
    }
    EXPECT_GT(read, 100);
    EXPECT_GT(refused, 100);
}

} // namespace
} // namespace hachure::test
