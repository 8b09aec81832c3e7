#include <hachure/components/edge_lines.h>
#include <hachure/components/gooch.h>
#include <hachure/components/surface.h>
#include <hachure/components/transform.h>
#include <hachure/runtime/app/app.h>
#include <hachure/runtime/scene/scene_parts.h>
#include <hachure/systems/capabilities.h>
#include <hachure/systems/model/model_extras.h>
#include <hachure/systems/model/spawn_model.h>
#include <hachure/systems/styles/style.h>
#include <hachure/tests/support/arm_model.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace hachure::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// Two triangles of two materials, as one mesh on the node "both" and another of the first material alone on "one".
assets::Model two_materials() {
    assets::Primitive triangle;
    triangle.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    triangle.normals.assign(3, {0, 0, 1});
    triangle.indices = {0, 1, 2};
    triangle.material = 0;
    assets::Primitive second = triangle;
    second.material = 1;
    assets::Model model;
    model.materials = {{.name = "skin"}, {.name = "cloth"}};
    model.meshes.push_back({"both", {triangle, second}, {}});
    model.meshes.push_back({"one", {triangle}, {}});
    model.nodes.resize(3);
    model.nodes[0] = {.name = "both", .mesh = 0};
    model.nodes[1] = {.name = "one", .mesh = 1};
    model.nodes[2] = {.name = "empty"};
    model.scenes.push_back({"scene", {0, 1, 2}, {}});
    return model;
}

class ModelExtrasTest : public testing::Test {
protected:
    ModelExtrasTest() { register_capabilities(app); }

    SpawnedModel spawn(const assets::Model& model) {
        SpawnedModel spawned = spawn_model(app.world(), model, &app.types());
        entities.assign(app.world().children(spawned.root).begin(), app.world().children(spawned.root).end());
        return spawned;
    }

    template <class C> const C* find(std::size_t entity) { return app.world().find<C>(entities.at(entity)); }

    App app;
    std::vector<Entity> entities; ///< below the root
};

TEST_F(ModelExtrasTest, NodesAndMaterialsGiveComponents) {
    assets::Model model = two_materials();
    model.materials[0].extras = R"({"gooch": {"b": 0.1, "y": 0.2}})";
    model.materials[1].extras = model.materials[0].extras;
    model.nodes[1].extras = R"({"gooch": {"b": 0.7}, "edge_lines": {}})";
    model.nodes[2].extras = R"({"transform": {"scale": [2, 2, 2]}})";
    EXPECT_THAT(spawn(model).warnings, ElementsAre());
    ASSERT_TRUE(find<Gooch>(0) && find<Gooch>(1));
    EXPECT_EQ(find<Gooch>(0)->b, 0.1f);
    EXPECT_EQ(find<Gooch>(1)->b, 0.7f) << "the node has the last word";
    EXPECT_EQ(find<Gooch>(1)->y, 0.2f);
    EXPECT_FALSE(find<EdgeLines>(0));
    EXPECT_TRUE(find<EdgeLines>(1));
    EXPECT_EQ(find<Transform>(2)->scale, glm::vec3(2));
}

TEST_F(ModelExtrasTest, WithoutTypesNothingIsRead) {
    assets::Model model = two_materials();
    model.nodes[1].extras = R"({"gooch": {"b": 0.7}, "nonsense": 1})";
    EXPECT_THAT(spawn_model(app.world(), model).warnings, ElementsAre());
    EXPECT_TRUE(app.world().query<const Gooch>().empty());
}

TEST_F(ModelExtrasTest, AStyleDoesNotEraseThem) {
    assets::Model model = two_materials();
    model.nodes[1].extras = R"({"gooch": {"b": 0.7}, "edge_lines": {"width": 5}})";
    spawn(model);
    apply_style(app.world(), app.types(),
                parse_style(app.types(), "s", R"({"hachure_style": 1, "surface": {"gooch": {"b": 0.3, "y": 0.9}}})"));
    EXPECT_EQ(find<Gooch>(0)->b, 0.3f);
    EXPECT_EQ(find<Gooch>(1)->b, 0.7f);
    EXPECT_EQ(find<Gooch>(1)->y, 0.9f) << "of which they say nothing";
    EXPECT_EQ(find<EdgeLines>(1)->width, 5.0f);
}

TEST_F(ModelExtrasTest, CopiesKeepThem) {
    assets::Model model = two_materials();
    model.nodes[1].extras = R"({"gooch": {"b": 0.7}})";
    const Entity copy = app.world().instantiate(spawn(model).root);
    apply_style(app.world(), app.types(), find_style(app.types(), "gooch"));
    EXPECT_EQ(app.world().get<Gooch>(app.world().children(copy)[1]).b, 0.7f);
}

TEST_F(ModelExtrasTest, MaterialsThatDisagreeAreSaidAndTheFirstWins) {
    assets::Model model = two_materials();
    model.materials[0].extras = R"({"gooch": {"b": 0.1}})";
    model.materials[1].extras = R"({"gooch": {"b": 0.2}})";
    EXPECT_THAT(spawn(model).warnings,
                ElementsAre(testing::AllOf(HasSubstr("material 'skin'"), HasSubstr("node 'both'"),
                                           HasSubstr("/materials/0/extras/hachure"))));
    EXPECT_EQ(find<Gooch>(0)->b, 0.1f);
}

TEST_F(ModelExtrasTest, SkinnedSurfacesStandElsewhere) {
    assets::Model model = arm_model();
    model.nodes[0].extras = R"({"gooch": {"b": 0.7}, "transform": {"translation": [1, 0, 0]}})";
    model.scenes[0].extras = R"({"animation": {"clip": "walk", "speed": 2}, "style": "gooch"})";
    const SpawnedModel spawned = spawn(model);
    EXPECT_THAT(spawned.warnings, ElementsAre());
    EXPECT_EQ(spawned.style, "gooch");
    const World& world = app.world();
    EXPECT_EQ(world.get<Gooch>(spawned.surfaces[0]).b, 0.7f);
    EXPECT_EQ(world.get<Transform>(spawned.surfaces[0]), Transform{});
    EXPECT_EQ(find<Transform>(0)->translation.x, 1.0f);
    EXPECT_TRUE(app.types().find("animation")->find(world, spawned.root));
}

TEST_F(ModelExtrasTest, WhatIsWrongIsSaidAndTheModelIsThere) {
    assets::Model model = two_materials();
    model.nodes[0].extras = R"({"gooch": {"b": 7, "bb": 1, "y": 0.5}, "nonsense": {}, "edge_lines": [1]})";
    model.nodes[2].extras = R"({"surface": {"tint": [1, 0, 0]}})";
    model.scenes[0].extras = R"({"animation": {"clip": "fly"}, "style": 3})";
    EXPECT_THAT(spawn(model).warnings,
                testing::UnorderedElementsAre(
                    testing::AllOf(HasSubstr("node 'both'"), HasSubstr("(/nodes/0/extras/hachure/gooch/b)")),
                    testing::AllOf(HasSubstr("no field 'bb'"), HasSubstr("/nodes/0/extras/hachure/gooch/bb")),
                    testing::AllOf(HasSubstr("no component 'nonsense'"), HasSubstr("/nodes/0/extras/hachure/nonsense")),
                    HasSubstr("/nodes/0/extras/hachure/edge_lines"), HasSubstr("/nodes/2/extras/hachure/surface"),
                    HasSubstr("'fly'"), HasSubstr("/scenes/0/extras/hachure/style")));
    EXPECT_EQ(find<Gooch>(0)->y, 0.5f) << "the right field of a component counts";
    EXPECT_FALSE(find<Surface>(2));
}

TEST_F(ModelExtrasTest, ToolsThatKnowOnlyNumbersCanSayAll) {
    assets::Model model = two_materials();
    model.nodes[0].extras =
        R"({"edge_lines": {"crease": 0, "border": 1, "color": "#ff0000"}, "animation": {"repeat": "once"}})";
    EXPECT_THAT(spawn(model).warnings, ElementsAre());
    EXPECT_FALSE(find<EdgeLines>(0)->crease);
    EXPECT_TRUE(find<EdgeLines>(0)->border);
    EXPECT_EQ(find<EdgeLines>(0)->color, glm::vec3(1, 0, 0));
}

/// What the part below was told.
struct Told {
    std::string text;
};

TEST_F(ModelExtrasTest, SceneParts) {
    ScenePart part{.name = "told", .doc = "for the test", .schema = {}, .read = {}, .write = {}};
    part.read = [](World& world, Entity entity, const ScenePartSource& source) {
        if (!source.value.is_string()) source.text.fail(source.pointer, "is no text");
        world.add(entity, Told{source.value.get<std::string>()});
    };
    part.write = [](const World&, Entity) { return std::nullopt; };
    add_scene_part(app.world(), part);
    assets::Model model = two_materials();
    model.nodes[0].extras = R"({"told": "hello"})";
    model.nodes[1].extras = R"({"told": 3})";
    EXPECT_THAT(spawn(model).warnings,
                ElementsAre(testing::AllOf(HasSubstr("is no text"), HasSubstr("/nodes/1/extras/hachure/told"))));
    ASSERT_TRUE(find<Told>(0));
    EXPECT_EQ(find<Told>(0)->text, "hello");
}

} // namespace
} // namespace hachure::test
