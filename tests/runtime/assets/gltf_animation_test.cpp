#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "gltf_builder.h"

namespace hachure::assets {
namespace {

using namespace gltf_testing;
using testing::HasSubstr;

/// One node with a mesh of two morph targets, and one channel with two keys.
GltfBuilder animated(const json& target, int output_width, std::size_t outputs, const char* interpolation = "LINEAR") {
    GltfBuilder builder;
    const int positions = builder.triangle_positions();
    builder.mesh({{"POSITION", positions}});
    builder.root["meshes"][0]["primitives"][0]["targets"] = {{{"POSITION", positions}}, {{"POSITION", positions}}};
    std::vector<float> values(outputs * static_cast<std::size_t>(output_width));
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<float>(i);
    const int input = builder.floats({0.5f, 2.0f}, 1);
    const int output = builder.floats(values, output_width);
    builder.add("animations", {{"name", "clip"},
                               {"samplers", {{{"input", input}, {"output", output}, {"interpolation", interpolation}}}},
                               {"channels", {{{"sampler", 0}, {"target", target}}}}});
    return builder;
}

json node_target(const char* path) { return {{"node", 0}, {"path", path}}; }

TEST(GltfAnimation, ReadsEveryPathAndInterpolation) {
    struct Case {
        const char* path;
        int width;
        std::size_t outputs;
        const char* interpolation;
        std::int32_t components;
        Interpolation expected;
    };
    for (const Case& c : {Case{"translation", 3, 2, "LINEAR", 3, Interpolation::linear},
                          Case{"rotation", 4, 2, "STEP", 4, Interpolation::step},
                          Case{"scale", 3, 6, "CUBICSPLINE", 3, Interpolation::cubic_spline},
                          Case{"weights", 1, 4, "LINEAR", 2, Interpolation::linear},
                          Case{"weights", 1, 12, "CUBICSPLINE", 2, Interpolation::cubic_spline}}) {
        const Model model = animated(node_target(c.path), c.width, c.outputs, c.interpolation).read();
        EXPECT_EQ(broken_promise(model), "") << c.path;
        const Animation& clip = model.animations.at(0);
        EXPECT_EQ(clip.name, "clip");
        EXPECT_EQ(clip.duration, 2.0f);
        const AnimationChannel& channel = clip.channels.at(0);
        EXPECT_EQ(channel.node, 0);
        EXPECT_EQ(channel.interpolation, c.expected);
        EXPECT_EQ(channel.components, c.components) << c.path;
        EXPECT_EQ(channel.times, (std::vector<float>{0.5f, 2.0f}));
        EXPECT_EQ(channel.values.size(), c.outputs * static_cast<std::size_t>(c.width));
        EXPECT_EQ(channel.values.back(), static_cast<float>(channel.values.size() - 1));
    }
}

TEST(GltfAnimation, KeepsPointers) {
    const json target = {{"path", "pointer"},
                         {"extensions", {{"KHR_animation_pointer", {{"pointer", "/materials/0/emissiveFactor"}}}}}};
    const Model model = animated(target, 3, 2).read();
    const AnimationChannel& channel = model.animations.at(0).channels.at(0);
    EXPECT_EQ(channel.path, AnimationPath::pointer);
    EXPECT_EQ(channel.pointer, "/materials/0/emissiveFactor");
    EXPECT_EQ(channel.node, -1);
    EXPECT_EQ(channel.components, 3);
    EXPECT_TRUE(model.warnings.empty()) << warnings_of(model);
}

TEST(GltfAnimation, SkipsChannelsThatMoveNothing) {
    for (const json& target : {json{{"path", "translation"}}, json{{"path", "pointer"}}}) {
        const Model model = animated(target, 3, 2).read();
        EXPECT_TRUE(model.animations.at(0).channels.empty());
        EXPECT_THAT(warnings_of(model), HasSubstr("without a target are skipped (first at /animations/0/channels/0)"));
    }
    GltfBuilder builder = animated(node_target("translation"), 3, 2);
    for (json& accessor : builder.root["accessors"]) accessor["count"] = accessor["type"] == "VEC3" ? 3 : 0;
    EXPECT_THAT(warnings_of(builder.read()), HasSubstr("without keys"));
}

TEST(GltfAnimation, RefusesSizesThatDoNotFit) {
    EXPECT_THAT(error_of(animated(node_target("translation"), 3, 3)), HasSubstr("/accessors/2"));
    EXPECT_THAT(error_of(animated(node_target("translation"), 4, 2)), HasSubstr("one VEC3 per key"));
    EXPECT_THAT(error_of(animated(node_target("rotation"), 3, 2)), HasSubstr("one VEC4 per key"));
    EXPECT_THAT(error_of(animated(node_target("weights"), 1, 2)), HasSubstr("morph target"));
    EXPECT_THAT(error_of(animated(node_target("scale"), 3, 2, "CUBICSPLINE")), HasSubstr("/accessors/2"));
    EXPECT_THAT(error_of(animated(node_target("colour"), 3, 2)), HasSubstr("/animations/0/channels/0/target/path"));
    EXPECT_THAT(error_of(animated(json{{"node", 7}, {"path", "scale"}}, 3, 2)),
                HasSubstr("/animations/0/channels/0/target/node"));
}

TEST(GltfAnimation, RefusesKeysThatAreNotFinite) {
    GltfBuilder times = animated(node_target("translation"), 3, 2);
    times.root["animations"][0]["samplers"][0]["input"] = times.floats({0, std::numeric_limits<float>::quiet_NaN()}, 1);
    EXPECT_THAT(error_of(times), HasSubstr("key time that is not finite"));
    GltfBuilder values = animated(node_target("translation"), 3, 2);
    values.root["animations"][0]["samplers"][0]["output"] =
        values.floats({0, 0, 0, 0, 0, std::numeric_limits<float>::infinity()}, 3);
    EXPECT_THAT(error_of(values), HasSubstr("key value that is not finite"));
}

} // namespace
} // namespace hachure::assets
