#include <hachure/runtime/assets/gltf_extras.h>

#include <gtest/gtest.h>

#include "gltf_builder.h"

namespace hachure::assets {
namespace {

using namespace gltf_testing;

/// What these extras say, as JSON; null for nothing. Warnings go to `said`.
json read(const json& extras, std::string* said = nullptr) {
    GltfWarnings warnings;
    const std::string text = hachure_extras({{"extras", extras}}, "/nodes/3", warnings);
    for (const std::string& line : warnings.take())
        if (said) *said += line + "\n";
    return text.empty() ? json() : json::parse(text);
}

TEST(GltfExtras, AllWaysToWriteThemMeanTheSame) {
    const json expected = json::parse(R"({"gooch": {"b": 0.5, "y": 0.25}, "edge_lines": {}})");
    EXPECT_EQ(read(json::parse(R"({"hachure": {"gooch": {"b": 0.5, "y": 0.25}, "edge_lines": {}}})")), expected);
    EXPECT_EQ(read({{"hachure", expected.dump()}}), expected) << "a text";
    EXPECT_EQ(read(json::parse(R"({"hachure": {"gooch": "{\"b\": 0.5, \"y\": 0.25}", "edge_lines": true}})")),
              expected);
    EXPECT_EQ(read(json::parse(R"({"hachure.gooch.b": 0.5, "hachure.gooch.y": 0.25, "hachure.edge_lines": 1})")),
              expected);
    EXPECT_EQ(read(json::parse(R"({"hachure.gooch": {"b": 0.5}, "hachure.gooch.y": 0.25, "hachure.edge_lines": {}})")),
              expected);
    EXPECT_EQ(read(json::parse(R"({"hachure": {"gooch": {"b": 0.1, "y": 0.25}}, "hachure.gooch.b": 0.5,
                                   "hachure.edge_lines": true, "hachure.edge_lines.width": 1})"))
                  .at("gooch"),
              expected.at("gooch"))
        << "longer keys come after shorter ones";
}

TEST(GltfExtras, ComponentsCanBeSwitchedOff) {
    EXPECT_EQ(read(json::parse(R"({"hachure.gooch": false, "hachure.gooch2": 0})")), json());
    EXPECT_EQ(read(json::parse(R"({"hachure": {"gooch": {}}, "hachure.gooch": 0})")), json());
}

TEST(GltfExtras, OthersDoNotConcernUs) {
    std::string said;
    EXPECT_EQ(read(json::parse(R"({"hachured": 1, "cycles": {"hachure": 2}, "": 3})"), &said), json());
    EXPECT_EQ(read("a text", &said), json());
    EXPECT_EQ(said, "");
    EXPECT_EQ(read({{"hachure", {{"style", "gooch"}}}}, &said), json({{"style", "gooch"}})) << "plain texts stay";
    EXPECT_EQ(said, "");
}

TEST(GltfExtras, WhatCannotBeUnderstoodIsSaid) {
    std::string said;
    EXPECT_EQ(read({{"hachure", "{\"gooch\": "}}, &said), json());
    EXPECT_NE(said.find("not valid JSON"), said.npos) << said;
    EXPECT_NE(said.find("/nodes/3/extras"), said.npos) << said;
    said.clear();
    EXPECT_EQ(read({{"hachure", json::array({1, 2})}}, &said), json());
    EXPECT_NE(said.find("no object"), said.npos) << said;
    said.clear();
    EXPECT_EQ(read({{"hachure", std::string(2000, '[')}}, &said), json());
    EXPECT_NE(said.find("no object"), said.npos) << said;
    said.clear();
    std::string deep = "{\"a\":";
    for (int i = 0; i < 4000; ++i) deep += "[";
    EXPECT_EQ(read({{"hachure", deep}}, &said), json());
    EXPECT_NE(said.find("not valid JSON"), said.npos) << said;
    said.clear();
    EXPECT_EQ(read({{"hachure", {{"script", {{"file", std::string(max_extras_bytes, 'x')}}}}}}, &said), json());
    EXPECT_NE(said.find("longer than 1 MiB"), said.npos) << said;
}

TEST(GltfExtras, ArriveAtNodesMaterialsAndScenes) {
    GltfBuilder builder;
    builder.mesh({{"POSITION", builder.triangle_positions()}});
    builder.root["nodes"][0]["extras"]["hachure.gooch.b"] = 0.5;
    builder.add("nodes", {{"name", "silent"}, {"extras", {{"other", 1}}}});
    builder.add("materials", {{"extras", {{"hachure", {{"edge_lines", true}}}}}});
    builder.root["scenes"] = {{{"nodes", {0, 1}}, {"extras", {{"hachure.style", "gooch"}}}}};
    const Model model = builder.read();
    EXPECT_EQ(model.nodes[0].extras, R"({"gooch":{"b":0.5}})");
    EXPECT_EQ(model.nodes[1].extras, "");
    EXPECT_EQ(model.materials[0].extras, R"({"edge_lines":{}})");
    EXPECT_EQ(model.scenes[0].extras, R"({"style":"gooch"})");
    EXPECT_TRUE(model.warnings.empty()) << warnings_of(model);
}

} // namespace
} // namespace hachure::assets
