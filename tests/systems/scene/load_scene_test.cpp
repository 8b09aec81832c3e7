#include <hachure/components/animation.h>
#include <hachure/components/camera.h>
#include <hachure/components/compose.h>
#include <hachure/components/edge_lines.h>
#include <hachure/components/gooch.h>
#include <hachure/components/light.h>
#include <hachure/components/rig.h>
#include <hachure/components/scene.h>
#include <hachure/components/surface.h>
#include <hachure/components/transform.h>
#include <hachure/runtime/scene/mesh_store.h>
#include <hachure/tests/support/given_models.h>
#include <hachure/tests/systems/scene/scene_fixture.h>

#include <fmt/format.h>

namespace hachure::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

TEST_F(SceneTest, MakesATreeOfEntitiesWithTheirComponents) {
    const LoadedScene scene = load(R"({"name": "Ship", "transform": {"translation": [1, 2, 3]},
        "children": [{"name": "Mast", "gooch": {"b": 0.25}}, {"light": {}}]}, {"name": "Eye", "camera": {"yfov": 1}})");
    ASSERT_EQ(scene.roots.size(), 2u);
    EXPECT_EQ(get<Transform>("Ship").translation, glm::vec3(1, 2, 3));
    EXPECT_EQ(world().parent(named("Ship/Mast")), named("Ship"));
    EXPECT_EQ(get<Gooch>("Mast").b, 0.25f);
    EXPECT_EQ(get<Gooch>("Mast").y, Gooch{}.y);
    EXPECT_TRUE(has<Transform>("Mast")) << "everything stands somewhere";
    EXPECT_EQ(world().children(named("Ship")).size(), 2u);
    EXPECT_EQ(get<Camera>("Eye").yfov, 1.0f);
    EXPECT_TRUE(scene.has_camera);
    EXPECT_TRUE(scene.has_light);
    EXPECT_TRUE(scene.points.empty());
    EXPECT_TRUE(scene.warnings.empty());
}

TEST_F(SceneTest, ANullComponentIsNone) {
    static_cast<void>(load(R"({"name": "A", "transform": null, "gooch": null})"));
    EXPECT_FALSE(has<Transform>("A"));
    EXPECT_FALSE(has<Gooch>("A"));
}

TEST_F(SceneTest, AModelIsReadOnceHoweverOftenItIsUsed) {
    const LoadedScene scene = load(R"({"name": "A", "model": "die.obj", "children": [{"name": "Child"}]},
        {"name": "B", "model": "./die.obj", "transform": {"translation": [10, 0, 0]}},
        {"model": "die.obj"}, {"name": "D", "model": "sub/../die.obj"})");
    EXPECT_EQ(world().resource<MeshStore>().mesh_count(), 1u);
    EXPECT_EQ(world().query<const Surface>().count(), 4u);
    EXPECT_EQ(world().children(named("A")).size(), 2u);
    EXPECT_EQ(world().children(named("B")).size(), 1u) << "copies are those of the model, not of its first user";
    EXPECT_EQ(world().query<With<SceneReference>>().count(), 4u) << "no prototype stays";
    EXPECT_EQ(scene.points.size(), 4u * 12);
    EXPECT_THAT(scene.points, testing::Contains(glm::vec3(11, 0, 0)));
    EXPECT_TRUE(has<Unsaved>("B/die"));
    EXPECT_FALSE(has<Unsaved>("B"));
}

TEST_F(SceneTest, LooksGoToTheSurfacesBelowAndInnerOnesRefineOuterOnes) {
    static_cast<void>(load(R"({"name": "A", "model": "die.obj", "look": "outer",
        "children": [{"name": "B", "model": "die.obj", "look": "inner"}]}, {"name": "C", "model": "die.obj"})",
                           R"(, "style": "gooch", "looks": {"outer": {"gooch": {"b": 0.1, "y": 0.2}},
                               "inner": {"gooch": {"b": 0.9}, "edge_lines": null}})"));
    EXPECT_EQ(get<Gooch>("A/die").b, 0.1f);
    EXPECT_EQ(get<Gooch>("B/die").b, 0.9f);
    EXPECT_EQ(get<Gooch>("B/die").y, 0.2f);
    EXPECT_EQ(get<Gooch>("C/die").b, Gooch{}.b) << "of the style";
    EXPECT_TRUE(has<EdgeLines>("A/die"));
    EXPECT_FALSE(has<EdgeLines>("B/die"));
    EXPECT_FALSE(has<Gooch>("A")) << "an entity without a surface shows nothing";
}

TEST_F(SceneTest, TheStyleAskedForTakesThePlaceOfTheScenesOwn) {
    write("mine.style.json", R"({"hachure_style": 1, "surface": {"gooch": {"b": 0.75}},
                                 "camera": {"compose": {"background": [0, 0, 0]}}})");
    const std::string entities = R"({"name": "A", "model": "die.obj"}, {"name": "Eye", "camera": {}})";
    static_cast<void>(load(entities, R"(, "style": "mine.style.json")"));
    EXPECT_EQ(get<Gooch>("A/die").b, 0.75f);
    EXPECT_EQ(get<Compose>("Eye").background, glm::vec3(0));
    app_ = make_app();
    static_cast<void>(load(entities, R"(, "style": "mine.style.json")", {"gooch", ""}));
    EXPECT_EQ(get<Gooch>("A/die").b, Gooch{}.b);
    app_ = make_app();
    static_cast<void>(load(entities, "", {"", "gooch"}));
    EXPECT_TRUE(has<Gooch>("A/die"));
    app_ = make_app();
    static_cast<void>(load(entities));
    EXPECT_FALSE(has<Gooch>("A/die"));
}

TEST_F(SceneTest, OverridesChangePartsOfAModelOrAScene) {
    write("inner.scene.json", R"({"hachure_scene": 1, "entities": [{"name": "Arm", "children":
        [{"name": "Hand", "model": "die.obj", "overrides": {"die": {"surface": {"visible": false}}}}]}]})");
    static_cast<void>(load(R"({"name": "A", "scene": "inner.scene.json"},
        {"name": "B", "scene": "inner.scene.json", "overrides": {"Arm/Hand": {"transform": {"scale": [2, 2, 2]}},
            "Hand/die": {"surface": {"visible": true}, "gooch": {"b": 0.5}}, "Arm": {"name": "Leg"}}})"));
    EXPECT_EQ(get<Transform>("A/Arm/Hand").scale, glm::vec3(1));
    EXPECT_FALSE(get<Surface>("A/Arm/Hand/die").visible);
    EXPECT_EQ(get<Transform>("B/Leg/Hand").scale, glm::vec3(2));
    EXPECT_TRUE(get<Surface>("B/Leg/Hand/die").visible) << "the outer one comes last";
    EXPECT_EQ(get<Gooch>("B/Leg/Hand/die").b, 0.5f);
}

TEST_F(SceneTest, ChildrenMayStandBelowAPartOfAModel) {
    static_cast<void>(load(R"({"name": "A", "model": "die.obj", "children": [{"name": "Hat", "below": "die"}]})"));
    EXPECT_EQ(world().parent(named("Hat")), named("A/die"));
}

TEST_F(SceneTest, EntityFieldsArePathsOfNamesInTheWholeScene) {
    write("car.scene.json", R"({"hachure_scene": 1, "entities": [{"name": "Eye", "follow": {"target": "Wheel"}},
        {"name": "Wheel"}]})");
    static_cast<void>(load(R"({"name": "First", "follow": {"target": "Ship/Mast", "distance": 3}},
        {"name": "Mast"}, {"name": "Ship", "children": [{"name": "Mast"}]}, {"name": "None", "follow": {"target": null}},
        {"name": "Car1", "scene": "car.scene.json"}, {"name": "Car2", "scene": "car.scene.json"})"));
    EXPECT_EQ(get<Follow>("First").target, named("Ship/Mast")) << "also one that comes later";
    EXPECT_EQ(get<Follow>("First").distance, 3.0f);
    EXPECT_EQ(get<Follow>("None").target, Entity::null);
    EXPECT_EQ(get<Follow>("Car1/Eye").target, named("Car1/Wheel"));
    EXPECT_EQ(get<Follow>("Car2/Eye").target, named("Car2/Wheel")) << "its own before another's";
}

TEST_F(SceneTest, FileFieldsAreRelativeToTheFileThatSaysThem) {
    write("deep/inner.scene.json",
          R"({"hachure_scene": 1, "entities": [{"name": "In", "follow": {"script": "a/../b.lua"}}]})");
    static_cast<void>(load(R"({"name": "Out", "follow": {"script": "b.lua"}}, {"scene": "deep/inner.scene.json"})"));
    EXPECT_EQ(get<Follow>("Out").script, (folder_ / "b.lua").string());
    EXPECT_EQ(get<Follow>("In").script, (folder_ / "deep/b.lua").string());
}

TEST_F(SceneTest, WhatIsNotKnownIsToldWithItsPlace) {
    const LoadedScene scene =
        load("\n  {\"name\": \"A\", \"zork\": 1,\n   \"gooch\": {\"b\": 0.5, \"zap\": []}}", ", \"more/so\": {}");
    EXPECT_EQ(get<Gooch>("A").b, 0.5f);
    std::vector<std::string> warnings;
    for (const std::string& warning : scene.warnings) warnings.push_back(without_folder(warning));
    EXPECT_THAT(warnings,
                ElementsAre("test.scene.json: a scene has no 'more/so' (line 1, column 33: /more~1so)",
                            "test.scene.json: component 'gooch' has no field 'zap' (line 4, column 31: "
                            "/entities/0/gooch/zap)",
                            "test.scene.json: there is no component 'zork' (line 3, column 25: /entities/0/zork)"));
}

TEST_F(SceneTest, ItsSchemaIsNothingUnknown) {
    const LoadedScene scene = load(R"({"name": "A"})", R"(, "$schema": "../scene.schema.json")");
    EXPECT_TRUE(scene.warnings.empty());
    EXPECT_THAT(save_scene(app_->world(), app_->types(), folder_.path()),
                HasSubstr(R"("$schema": "../scene.schema.json")"));
}

TEST_F(SceneTest, ASceneWithinItselfIsRefused) {
    write("a.scene.json", R"({"hachure_scene": 1, "entities": [{"scene": "b.scene.json"}]})");
    write("b.scene.json", R"({"hachure_scene": 1, "entities": [{"scene": "sub/../a.scene.json"}]})");
    EXPECT_THAT(fault(R"({"scene": "a.scene.json"})"), HasSubstr("is a scene that contains itself"));
    EXPECT_THAT(fault(R"({"scene": "test.scene.json"})"), HasSubstr("is a scene that contains itself"));
}

TEST_F(SceneTest, ScenesThatMultiplyEndSoonEnough) {
    write("s0.scene.json", R"({"hachure_scene": 1, "entities": [{}]})");
    for (int i = 1; i <= 31; ++i)
        write(fmt::format("s{}.scene.json", i),
              fmt::format(R"({{"hachure_scene": 1, "entities": [{{"scene": "s{}.scene.json"}}]}})", i - 1));
    EXPECT_THAT(fault(R"({"scene": "s31.scene.json"})"), HasSubstr("stands too deep: scenes within scenes"));
    EXPECT_EQ(fault(R"({"scene": "s29.scene.json"})"), "none");
}

struct FaultCase {
    const char* entities;
    const char* says;
};

class SceneFaultTest : public SceneTest, public testing::WithParamInterface<FaultCase> {};

TEST_P(SceneFaultTest, IsNamedWithItsPlace) { EXPECT_EQ(fault(GetParam().entities), GetParam().says); }

INSTANTIATE_TEST_SUITE_P(
    Faults, SceneFaultTest,
    testing::Values(
        FaultCase{"3", "test.scene.json: an entity is an object (line 2, column 14: /entities/0)"},
        FaultCase{R"({"gooch": {"b": 2}})", "test.scene.json: gooch.b: 2 is outside [0, 1] (line 2, column 30: "
                                            "/entities/0/gooch/b)"},
        FaultCase{R"({"gooch": 7})", "test.scene.json: gooch: the fields of a component are an object (line 2, column "
                                     "24: /entities/0/gooch)"},
        FaultCase{R"({"transform": {"translation": [1, 2]}})",
                  "test.scene.json: transform.translation: \"1 2\" has 2 numbers instead of 3 (line 2, column 44: "
                  "/entities/0/transform/translation)"},
        FaultCase{R"({"transform": {"translation": [1, 2, 1e39]}})",
                  "test.scene.json: transform.translation: \"1e+39\" is too large or too small (line 2, column 44: "
                  "/entities/0/transform/translation)"},
        FaultCase{R"({"camera": {"projection": "fish"}})",
                  "test.scene.json: camera.projection: \"fish\" is none of perspective, orthographic (line 2, column "
                  "40: /entities/0/camera/projection)"},
        FaultCase{R"({"model": "none.obj"})",
                  "test.scene.json: none.obj: there is no such file (line 2, column 24: /entities/0/model)"},
        FaultCase{R"({"model": 3})",
                  "test.scene.json: a model is the path of a file (line 2, column 24: /entities/0/model)"},
        FaultCase{R"({"model": "die.obj", "scene": "a.scene.json"})",
                  "test.scene.json: an entity has a model or a scene, not both (line 2, column 44: "
                  "/entities/0/scene)"},
        FaultCase{R"({"name": "A"}, {"look": "none"})",
                  "test.scene.json: the scene has no such look (line 2, column 38: /entities/1/look)"},
        FaultCase{R"({"model": "die.obj", "overrides": {"dice": {}}})",
                  "test.scene.json: nothing below the entity is called 'dice' (line 2, column 57: "
                  "/entities/0/overrides/dice)"},
        FaultCase{R"({"follow": {"target": "Nobody"}})",
                  "test.scene.json: follow.target: no entity is called 'Nobody' (line 2, column 36: "
                  "/entities/0/follow/target)"},
        FaultCase{R"({"surface": {}})",
                  "test.scene.json: surface: only a model gives an entity a surface (line 2, column 26: "
                  "/entities/0/surface)"},
        FaultCase{R"({"children": [{"children": 5}]})",
                  "test.scene.json: the children are a list (line 2, column 41: /entities/0/children/0/children)"},
        FaultCase{R"({"name": 5})", "test.scene.json: name: the fields of a component are an object (line 2, column "
                                    "23: /entities/0/name)"}));

TEST_F(SceneTest, OtherDocumentsAreNoScenes) {
    const auto refused = [&](const std::string& text) {
        try {
            static_cast<void>(load_text(text));
        } catch (const Error& error) {
            return without_folder(error.what());
        }
        return std::string("none");
    };
    EXPECT_EQ(refused("[]"), "test.scene.json: is not a scene: it lacks \"hachure_scene\"");
    EXPECT_EQ(refused("{\"hachure_scene\": 2}"),
              "test.scene.json: the version is not one of 0 to 1 (line 1, column 19: /hachure_scene)");
    EXPECT_EQ(refused("{\"hachure_scene\": -1}"),
              "test.scene.json: the version is not one of 0 to 1 (line 1, column 19: /hachure_scene)");
    EXPECT_THAT(refused("{\"hachure_scene\": 1, \"a\": 1, \"a\": 2}"), HasSubstr("has the key 'a' twice"));
    EXPECT_EQ(refused("{\"hachure_scene\": 1}"), "none") << "an empty scene";
}

TEST_F(SceneTest, VersionZeroIsMigrated) {
    static_cast<void>(load_text(R"({"hachure_scene": 0, "style": "gooch", "objects": [
        {"id": "Hat", "parent": "Head", "components": {"gooch": {"b": 0.5}}},
        {"id": "Head", "file": "die.obj", "position": [0, 1, 0], "components": {"transform": {"scale": [2, 2, 2]}}},
        {"id": "Alone", "parent": null}]})"));
    EXPECT_EQ(world().parent(named("Hat")), named("Head"));
    EXPECT_EQ(get<Gooch>("Hat").b, 0.5f);
    EXPECT_EQ(get<Transform>("Head").translation, glm::vec3(0, 1, 0));
    EXPECT_EQ(get<Transform>("Head").scale, glm::vec3(2));
    EXPECT_TRUE(has<Surface>("Head/die"));
    EXPECT_FALSE(world().parent(named("Alone")));
    EXPECT_THAT(save(), HasSubstr("\"hachure_scene\": 1"));
}

TEST_F(SceneTest, FaultsOfAnOldFileAreToldWhereTheyStandInIt) {
    const auto refused = [&](const std::string& objects) {
        try {
            static_cast<void>(load_text("{\"hachure_scene\": 0, \"objects\": [\n" + objects + "]}"));
        } catch (const Error& error) {
            return without_folder(error.what());
        }
        return std::string("none");
    };
    EXPECT_EQ(refused("{\"id\": \"A\"},\n{\"parent\": \"A\", \"position\": [1]}"),
              "test.scene.json: transform.translation: \"1\" has 1 numbers instead of 3 (line 3, column 29: "
              "/objects/1/position)");
    EXPECT_EQ(refused("{\"id\": \"A\", \"parent\": \"B\"},\n{\"id\": \"B\", \"parent\": \"A\"}"),
              "test.scene.json: entities hang on each other in a circle (line 1, column 33: /objects)");
    EXPECT_EQ(refused("{\"parent\": \"C\"}"),
              "test.scene.json: there is no entity of that id (line 2, column 12: /objects/0/parent)");
}

TEST_F(SceneTest, InspectionFindsEveryFault) {
    write("inner.scene.json", R"({"hachure_scene": 1, "entities": [{"gooch": {"y": 5}}]})");
    const auto file = write("test.scene.json", R"({"hachure_scene": 1, "style": "none", "looks": {"a": {"gooch": 1}},
        "entities": [{"gooch": {"b": 5, "y": -1}}, {"scene": "inner.scene.json"}, {"scene": "inner.scene.json"},
                     {"model": "none.obj"}, {"zork": 1}]})");
    const SceneFindings findings = inspect_scene(*app_, file);
    std::vector<std::string> where;
    for (const SceneFault& fault : findings.faults) where.push_back(fault.where);
    EXPECT_THAT(where, testing::UnorderedElementsAre(HasSubstr("/style"), HasSubstr("/looks/a/gooch"),
                                                     HasSubstr("/entities/0/gooch/b"), HasSubstr("/entities/0/gooch/y"),
                                                     HasSubstr("/entities/0/gooch/y"), HasSubstr("/entities/3/model")));
    EXPECT_EQ(findings.warnings.size(), 1u);
}

TEST_F(SceneTest, AnAnimationBesideAModelPlaysIt) {
    const auto fox = given_models() / "characters/khronos/Fox.glb";
    if (given_models().empty() || !std::filesystem::exists(fox)) GTEST_SKIP() << no_given_models;
    const std::string path = nlohmann::json(fox.string()).dump();
    const LoadedScene scene = load("{\"name\": \"Fox\", \"model\": " + path +
                                   ", \"animation\": {\"clip\": \"Run\"}}, {\"name\": \"Other\", \"model\": " + path +
                                   "}, {\"name\": \"Third\", \"model\": " + path + "}");
    EXPECT_TRUE(has<Rig>("Fox"));
    EXPECT_EQ(get<Animation>("Fox").clip, "Run");
    EXPECT_FALSE(has<Animation>("Other"));
    EXPECT_EQ(get<Rig>("Third").clips, get<Rig>("Fox").clips);
    const Entity hip = named("Other/root/_rootJoint/b_Root_00/b_Hip_01");
    ASSERT_TRUE(hip);
    EXPECT_THAT(get<Rig>("Other").nodes, testing::Contains(hip));
    EXPECT_TRUE(scene.warnings.empty());
    const std::string text = save();
    app_ = make_app();
    static_cast<void>(load_text(text));
    EXPECT_EQ(save(), text);
    EXPECT_EQ(get<Animation>("Fox").clip, "Run");
}

} // namespace
} // namespace hachure::test
