#include <hachure/runtime/ecs/component_json.h>
#include <hachure/runtime/error.h>
#include <hachure/tests/runtime/ecs/snapshot/snapshot_support.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace hachure::test {
namespace {

using nlohmann::json;
using testing::StrEq;
using testing::ThrowsMessage;

class ComponentJsonTest : public testing::Test {
protected:
    std::string text(JsonFields which = JsonFields::differing) const { return to_json(type, &value, which).dump(); }

    TypeRegistry registry;
    const TypeInfo& type = registry.add<Everything>();
    Everything value;
};

TEST_F(ComponentJsonTest, WritesWhatDiffers) {
    EXPECT_EQ(text(), "{}");
    value.on = false;
    value.seed = 18'446'744'073'709'551'614u;
    value.ratio = 0.05f;
    value.paint = {0.1f, 0.2f, 1};
    value.rotation = glm::quat(0.8f, 0, 0.6f, 0);
    value.lens = Lens::fisheye;
    value.target = {12, 3};
    EXPECT_EQ(text(), R"({"lens":"fisheye","on":false,"paint":[0.1,0.2,1.0],"ratio":0.05,"rotation":[0.0,0.6,0.0,0.8],)"
                      R"("seed":18446744073709551614,"target":"12v3"})");
}

TEST_F(ComponentJsonTest, WritesAllWhenAsked) {
    const json all = to_json(type, &value, JsonFields::all);
    EXPECT_EQ(all.size(), type.fields.size());
    EXPECT_EQ(all["title"], "untitled");
    EXPECT_EQ(all["exact"], 0.1);
    EXPECT_TRUE(all["target"].is_null());
    EXPECT_EQ(registry.types().size(), 1u);
}

TEST_F(ComponentJsonTest, AnyComponentComesBackExactly) {
    for (std::uint64_t seed = 1; seed < 40; ++seed) {
        World world = RandomWorld(seed).make(60);
        for (auto [entity, component] : world.query<const Everything>()) {
            for (const JsonFields which : {JsonFields::differing, JsonFields::all}) {
                Everything back;
                from_json(type, &back, json::parse(to_json(type, &component, which).dump()));
                for (const FieldInfo& field : type.fields)
                    ASSERT_EQ(field.get(&back), field.get(&component)) << field.name;
            }
        }
    }
}

TEST_F(ComponentJsonTest, TakesWhatUsersType) {
    from_json(type, &value, json::parse(R"({"paint": "#ff0000", "small": "7", "direction": "0 1 0", "on": "false"})"));
    EXPECT_EQ(value.paint, glm::vec3(1, 0, 0));
    EXPECT_EQ(value.small, 7);
    EXPECT_EQ(value.direction, glm::vec3(0, 1, 0));
    EXPECT_FALSE(value.on);
    EXPECT_EQ(value.title, "untitled") << "others stay";
}

TEST_F(ComponentJsonTest, ErrorsNameComponentFieldAndPlaceAndNothingIsWritten) {
    const auto refused = [&](const char* fields, const char* message) {
        EXPECT_THAT(
            [&] {
                from_json(type, &value, json::parse(fields), {"a.json", "/x"});
            },
            ThrowsMessage<Error>(StrEq(message)))
            << fields;
        EXPECT_EQ(text(), "{}");
    };
    refused("[]", "a.json: everything: the fields of a component are an object (/x)");
    refused(R"({"no": 1})", "a.json: component 'everything' has no field 'no' (/x/no)");
    refused(R"({"big": 1, "small": 11})", "a.json: everything.small: 11 is outside [-10, 10] (/x/small)");
    refused(R"({"small": 1.5})", "a.json: everything.small: \"1.5\" is no integer (/x/small)");
    refused(R"({"count": -1})", "a.json: everything.count: \"-1\" is no integer (/x/count)");
    refused(R"({"small": [1]})", "a.json: everything.small: the value is no integer (/x/small)");
    refused(R"({"title": 5})", "a.json: everything.title: the value is no text (/x/title)");
    refused(R"({"ratio": null})", "a.json: everything.ratio: the value is no real (/x/ratio)");
    refused(R"({"offset": [1, 2, 3]})", "a.json: everything.offset: \"1 2 3\" has 3 numbers instead of 2 (/x/offset)");
    refused(R"({"offset": [1, "2"]})", "a.json: everything.offset: an element is not a number (/x/offset)");
    refused(R"({"target": 5})",
            "a.json: everything.target: \"5\" is neither null nor a handle such as 12v3 (/x/target)");
    refused(R"({"lens": {}})", "a.json: everything.lens: the value is no enumeration (/x/lens)");
    EXPECT_THAT([&] { from_json(type, &value, json::parse(R"({"ratio": 9})")); },
                ThrowsMessage<Error>(StrEq("everything.ratio: 9 is outside [0, 0.1] (/ratio)")));
}

TEST_F(ComponentJsonTest, ErrorsSayWherePlacesStandForWhoeverKnows) {
    const JsonPlace place{"a.json", "/x", [](std::string_view at) { return "line 7: " + std::string(at); }};
    EXPECT_THAT([&] { from_json(type, &value, json::parse(R"({"ratio": 9})"), place); },
                ThrowsMessage<Error>(StrEq("a.json: everything.ratio: 9 is outside [0, 0.1] (line 7: /x/ratio)")));
    EXPECT_THAT(
        [&] { from_json(type, &value, 5, place); },
        ThrowsMessage<Error>(StrEq("a.json: everything: the fields of a component are an object (line 7: /x)")));
}

TEST_F(ComponentJsonTest, FieldsAreReadAndWrittenOneByOneToo) {
    const FieldInfo& ratio = *type.field("ratio");
    EXPECT_EQ(to_json(ratio, field_from_json(ratio, 0.05)), 0.05);
    EXPECT_THAT([&] { static_cast<void>(field_from_json(ratio, 9)); },
                ThrowsMessage<Error>(StrEq("everything.ratio: 9 is outside [0, 0.1]")));
}

} // namespace
} // namespace hachure::test
