#include <hachure/components/camera.h>
#include <hachure/components/gooch.h>
#include <hachure/components/light.h>
#include <hachure/components/scene.h>
#include <hachure/components/surface.h>
#include <hachure/components/transform.h>
#include <hachure/runtime/scene/scene_parts.h>
#include <hachure/tests/systems/scene/scene_fixture.h>

#include <bit>
#include <cmath>
#include <cstring>
#include <utility>

namespace hachure::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

class SaveScene : public SceneTest {
protected:
    /// Loads what is saved into a new app, and checks that the world and its text are the same.
    void expect_same_again() {
        const std::string text = save();
        const nlohmann::json before = described(world(), app_->types());
        const std::unique_ptr<App> first = std::exchange(app_, make_app());
        static_cast<void>(load_text(text));
        EXPECT_EQ(described(world(), app_->types()), before);
        EXPECT_EQ(save(), text);
    }
};

TEST_F(SaveScene, LoadingAndSavingAgainGivesTheSameTextAndTheSameWorld) {
    write("deep/inner.scene.json", R"({"hachure_scene": 1, "looks": {"l": {"gooch": {}}}, "entities":
        [{"name": "Arm", "children": [{"name": "Hand", "model": "../die.obj", "look": "l"}]}]})");
    static_cast<void>(load(
        R"(
        {"name": "Ship", "transform": {"translation": [1.1, -0.0, 1e-7], "rotation": [0, 0.6, 0, 0.8]}, "zork": [1.0, {"a": null}],
         "children": [{"name": "Mast", "gooch": {"b": 0.1, "zap": "\u00e4\n"}}, {"name": "Mast", "light": {"color": "#ff8800"}}]},
        {"model": "die.obj", "look": "l"}, {"name": "B", "model": "die.obj", "transform": null,
         "overrides": {"die": {"surface": {"tint": [0.5, 0.25, 1]}, "follow": {"script": "x.lua"}}},
         "children": [{"name": "Hat", "below": "die", "follow": {"target": "Ship", "script": "s/t.lua"}}]},
        {"name": "In", "scene": "deep/inner.scene.json", "look": "l",
         "overrides": {"Arm/Hand": {"transform": {"scale": [2, 2, 2]}, "name": "Paw"}}},
        {"name": "Eye", "camera": {"yfov": 0.7}, "follow": {"target": "In/Arm/Paw"}},
        {"name": "Bare eye", "camera": {"active": false}, "compose": null}, {})",
        R"(, "doc": "d\"oc", "style": "gooch", "zoo": {"x": 1}, "looks": {"l": {"gooch": {"b": 0.3}, "zork": 1}})"));
    expect_same_again();
    EXPECT_THAT(save(), HasSubstr("\"script\": \"s/t.lua\""));
}

TEST_F(SaveScene, WritesWhatDiffersFromDefaults) {
    static_cast<void>(load(R"({"name": "A", "transform": {"translation": [0, 0, 0]}, "gooch": {"b": 0.4}},
        {"name": "B", "gooch": {"b": 0.1}, "transform": {"scale": [1, 2, 1]}})"));
    EXPECT_EQ(save(), R"({
  "hachure_scene": 1,
  "entities": [
    { "name": "A", "gooch": {} },
    { "name": "B", "transform": { "scale": [1, 2, 1] }, "gooch": { "b": 0.1 } }
  ]
}
)");
}

TEST_F(SaveScene, WhatTheStyleGivesIsNotWritten) {
    static_cast<void>(load(R"({"name": "Eye", "camera": {}}, {"model": "die.obj"})", R"(, "style": "gooch")"));
    EXPECT_THAT(save(), Not(HasSubstr("compose")));
    EXPECT_THAT(save(), Not(HasSubstr("edge_lines")));
}

TEST_F(SaveScene, PathsAreRelativeToTheNewFolder) {
    static_cast<void>(load(R"({"model": "die.obj"}, {"follow": {"script": "a.lua"}})",
                           R"(, "looks": {"l": {"follow": {"script": "b.lua"}}})"));
    write("other/x", "");
    EXPECT_TRUE(write_scene(world(), app_->types(), folder_ / "other/new.scene.json").empty());
    app_ = make_app();
    static_cast<void>(load_scene(*app_, folder_ / "other/new.scene.json"));
    EXPECT_EQ(world().query<const Surface>().count(), 1u);
    EXPECT_EQ(std::get<const Follow&>(*world().query<const Follow>().begin()).script, (folder_ / "a.lua").string());
    std::ifstream stream(folder_ / "other/new.scene.json");
    const std::string text{std::istreambuf_iterator<char>(stream), {}};
    EXPECT_THAT(text, HasSubstr("\"model\": \"../die.obj\""));
    EXPECT_THAT(text, HasSubstr("\"script\": \"../b.lua\""));
}

TEST_F(SaveScene, WhatAProgramMadeIsWrittenToo) {
    const Entity ship = world().create_with(Name{"Ship"}, Transform{.translation = {1, 0, 0}});
    const Entity bare = world().create_with(Gooch{});
    world().set_parent(bare, ship);
    world().create_with(Name{"Mine"}, Camera{}, Unsaved{});
    EXPECT_THAT(save(), Not(HasSubstr("Mine")));
    EXPECT_THAT(save(), HasSubstr("{ \"transform\": null, \"gooch\": {} }"));
    const nlohmann::json before = described(world(), app_->types(), ship);
    const std::string text = save();
    app_ = make_app();
    static_cast<void>(load_text(text));
    EXPECT_EQ(described(world(), app_->types(), named("Ship")), before);
}

TEST_F(SaveScene, WhatAFileCannotSayIsToldOrRefused) {
    const Entity nameless = world().create_with(Transform{});
    world().create_with(Name{"A"}, Follow{.target = nameless});
    world().create_with(Name{"S"}, Surface{});
    std::vector<std::string> warnings;
    static_cast<void>(save_scene(world(), app_->types(), folder_.path(), &warnings));
    EXPECT_THAT(warnings, ElementsAre("entity 'A' follow.target refers to an entity that no path of names finds",
                                      "entity 'S' has a surface that no file made"));
    world().create_with(Name{"N"}, Transform{.translation = {std::nanf(""), 0, 0}});
    EXPECT_THROW(static_cast<void>(save()), Error);
    EXPECT_THROW(static_cast<void>(write_scene(world(), app_->types(), folder_ / "n.scene.json")), Error);
    EXPECT_FALSE(std::filesystem::exists(folder_ / "n.scene.json"));
}

TEST_F(SaveScene, TheDeepestTreeThatCanBeReadCanBeWritten) {
    const auto nested = [](int levels) {
        std::string entities = "{}";
        for (int i = 1; i < levels; ++i) entities = R"({"children": [)" + entities + "]}";
        return entities;
    };
    EXPECT_THAT(fault(nested(256)), HasSubstr("is nested deeper than 512 levels"));
    static_cast<void>(load(nested(255)));
    expect_same_again();
    Entity deep = world().create_with(Name{"0"});
    for (int i = 1; i < 300; ++i) {
        const Entity below = world().create_with(Name{std::to_string(i)});
        world().set_parent(below, std::exchange(deep, below));
    }
    EXPECT_THROW(static_cast<void>(save()), Error);
}

TEST_F(SaveScene, NumbersComeBackBitByBit) {
    std::vector<float> numbers{0.1f,  1.0f / 3.0f, 16777216.0f, 1e-45f, 3.4028235e38f, 1.17549435e-38f,
                               1e16f, 123456.7f,   -0.0f,       5e-7f,  2.5e15f};
    for (std::uint32_t i = 1; i < 2000; ++i) {
        const std::uint32_t bits = i * 2654435761u;
        float number = 0;
        std::memcpy(&number, &bits, sizeof(number));
        if (std::isfinite(number)) numbers.push_back(number);
    }
    for (const float number : numbers) world().create_with(Transform{.translation = {number, -number, 1}});
    const std::string text = save();
    app_ = make_app();
    const LoadedScene scene = load_text(text);
    ASSERT_EQ(scene.roots.size(), numbers.size());
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const float read = world().get<Transform>(scene.roots[i]).translation.x;
        EXPECT_EQ(std::bit_cast<std::uint32_t>(read), std::bit_cast<std::uint32_t>(numbers[i])) << numbers[i];
    }
    EXPECT_EQ(save(), text);
}

/// A part that holds a number.
struct Weight {
    double grams = 0;
};

TEST_F(SaveScene, PartsAreReadLastAndWrittenAgain) {
    const auto add_part = [](App& app) {
        ScenePart part{.name = "weight", .doc = "how heavy"};
        part.read = [](World& world, Entity entity, const ScenePartSource& source) {
            if (!source.value.is_number()) source.text.fail(source.pointer, "weight is a number");
            if (source.value > 1000) source.warnings.push_back("heavy");
            NameIndex index;
            index.update(world);
            EXPECT_TRUE(index.find(world, "Later")) << "all entities exist";
            world.add(entity, Weight{source.value.get<double>()});
        };
        part.write = [](const World& world, Entity entity) -> std::optional<nlohmann::json> {
            const Weight* weight = world.find<Weight>(entity);
            return weight ? std::optional(nlohmann::json(weight->grams)) : std::nullopt;
        };
        add_scene_part(app.world(), std::move(part));
    };
    add_part(*app_);
    const LoadedScene scene = load(R"({"name": "A", "weight": 2000.5}, {"name": "Later"})");
    EXPECT_THAT(scene.warnings, ElementsAre("heavy"));
    EXPECT_EQ(get<Weight>("A").grams, 2000.5);
    EXPECT_THAT(save(), HasSubstr("\"weight\": 2000.5"));
    EXPECT_EQ(fault(R"({"name": "Later", "weight": "much"})"),
              "test.scene.json: weight is a number (line 2, column 42: /entities/0/weight)");
}

} // namespace
} // namespace hachure::test
