#include <hachure/components/compose.h>
#include <hachure/components/edge_lines.h>
#include <hachure/components/gooch.h>
#include <hachure/components/implicit_brush.h>
#include <hachure/components/picture.h>
#include <hachure/components/picture_coat.h>
#include <hachure/components/scene.h>
#include <hachure/runtime/error.h>
#include <hachure/systems/styles/style.h>
#include <hachure/tests/support/drawn_scene.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace hachure {
namespace {

using ::testing::HasSubstr;

class StyleTest : public ::testing::Test {
protected:
    StyleTest() { register_capabilities(app); }

    std::string fault_of(std::string_view json) {
        try {
            static_cast<void>(parse_style(app.types(), "mine.json", json));
        } catch (const Error& error) {
            return error.what();
        }
        return "";
    }

    App app;
};

TEST_F(StyleTest, GoesToSurfacesAndCameras) {
    World& world = app.world();
    const Entity surface = world.create_with(Surface{}, Transform{}), camera = world.create_with(Camera{}, Transform{});
    const Style style = parse_style(app.types(), "mine.json", R"({"hachure_style": 1, "name": "mine", "doc": "a test",
        "surface": {"gooch": {"b": 0.55, "printed_equation": true}, "edge_lines": {"color": [0.5, 0, 1]}},
        "camera": {"compose": {"background": [0, 0.25, 1]}}})");
    EXPECT_EQ(style.name, "mine");
    EXPECT_EQ(style.doc, "a test");
    apply_style(world, app.types(), style);
    EXPECT_EQ(world.get<Gooch>(surface), (Gooch{.b = 0.55f, .printed_equation = true}));
    EXPECT_EQ(world.get<EdgeLines>(surface).color, glm::vec3(0.5f, 0, 1));
    EXPECT_EQ(world.get<Compose>(camera).background, glm::vec3(0, 0.25f, 1));
    EXPECT_FALSE(world.has<Gooch>(camera));
    EXPECT_FALSE(world.has<Compose>(surface));
}

TEST_F(StyleTest, PicturesTakeTheirSectionAndWhatMeansSomethingOnThem) {
    World& world = app.world();
    const Entity picture = world.create_with(Picture{.file = "a.png"}), surface = world.create_with(Surface{});
    const Style both = parse_style(app.types(), "mine.json", R"({"hachure_style": 1,
        "surface": {"gooch": {}, "picture_coat": {"show": "tone"}}, "picture": {"picture_coat": {"bands": 5}}})");
    apply_style(world, app.types(), both);
    EXPECT_EQ(world.get<PictureCoat>(picture), (PictureCoat{.bands = 5}));
    EXPECT_EQ(world.get<Picture>(picture).file, "a.png");
    EXPECT_FALSE(world.has<Gooch>(picture));
    EXPECT_TRUE(world.has<Gooch>(surface));
    const Style surfaces =
        parse_style(app.types(), "mine.json", R"({"hachure_style": 1, "surface": {"picture_coat": {"show": "tone"}}})");
    apply_style(world, surfaces, picture);
    EXPECT_EQ(world.get<PictureCoat>(picture).show, PictureShow::tone);
    EXPECT_TRUE(find_style(app.types(), "gooch").picture.empty());
    EXPECT_THAT(fault_of(R"({"hachure_style": 1, "picture": {"picture_coat": {"bands": 1}}})"),
                HasSubstr("/picture/picture_coat"));
}

TEST_F(StyleTest, PartsStandBelowEachCameraUntilAnotherStyleComes) {
    World& world = app.world();
    const Entity camera = world.create_with(Camera{}, Transform{}), other = world.create_with(Camera{}, Transform{});
    const Entity own = world.create_with(Name{"own"});
    world.set_parent(own, camera);
    const Style style = parse_style(app.types(), "mine.json", R"({"hachure_style": 1, "parts": [
        {"name": "folds", "implicit_brush": {"feature": "valleys"}}, {"implicit_brush": {}, "compose": {}}]})");
    for (int i = 0; i < 2; ++i) apply_style(world, app.types(), style); // again changes nothing
    ASSERT_EQ(world.children(camera).size(), 3u);
    ASSERT_EQ(world.children(other).size(), 2u);
    const Entity folds = world.children(camera)[1], second = world.children(camera)[2];
    EXPECT_EQ(world.children(camera)[0], own);
    EXPECT_EQ(world.get<Name>(folds).text, "folds");
    EXPECT_EQ(world.get<ImplicitBrush>(folds), (ImplicitBrush{.feature = BrushFeature::valleys}));
    EXPECT_EQ(world.get<Name>(second).text, "part 2");
    EXPECT_TRUE(world.has<Compose>(second));
    EXPECT_TRUE(world.has<Unsaved>(folds));
    apply_style(world, parse_style(app.types(), "mine.json", R"({"hachure_style": 1})"), camera);
    EXPECT_EQ(world.children(camera).size(), 1u);
    EXPECT_EQ(world.children(other).size(), 2u);
}

TEST_F(StyleTest, EveryBuiltInStyleIsFoundByItsNameAndDescribed) {
    ASSERT_FALSE(built_in_styles().empty());
    for (const BuiltInStyle& entry : built_in_styles()) {
        const Style style = find_style(app.types(), entry.name);
        EXPECT_EQ(style.name, entry.name);
        EXPECT_FALSE(style.doc.empty());
        EXPECT_FALSE(style.surface.empty());
    }
}

TEST_F(StyleTest, ErrorsNameTheFileAndThePlaceInIt) {
    const std::vector<std::pair<const char*, const char*>> cases = {
        {R"({"hachure_style": 1, "surface": {"goch": {}}})", "/surface/goch"},
        {R"({"hachure_style": 1, "surface": {"gooch": {"c": 1}}})", "/surface/gooch/c"},
        {R"({"hachure_style": 1, "surface": {"gooch": {"b": 1.5}}})", "/surface/gooch/b"},
        {R"({"hachure_style": 1, "surface": {"gooch": {"b": [1, 2, 3, 4, 5]}}})", "/surface/gooch/b"},
        {R"({"hachure_style": 1, "surface": {"gooch": {"b": {}}}})", "/surface/gooch/b"},
        {R"({"hachure_style": 1, "surface": {"gooch": {"b": null}}})", "/surface/gooch/b"},
        {R"({"hachure_style": 1, "surface": {"gooch": {"printed_equation": 3}}})", "/surface/gooch/printed_equation"},
        {R"({"hachure_style": 1, "surface": {"edge_lines": {"color": [1, "a", 0]}}})", "/surface/edge_lines/color"},
        {R"({"hachure_style": 1, "surface": {"edge_lines": {"color": [1, 0]}}})", "/surface/edge_lines/color"},
        {R"({"hachure_style": 1, "surface": {"gooch": 4}})", "/surface/gooch"},
        {R"({"hachure_style": 1, "camera": []})", "/camera"},
        {R"({"hachure_style": 1, "cameras": {}})", "/cameras"},
        {R"({"hachure_style": 1, "parts": {}})", "/parts"},
        {R"({"hachure_style": 1, "parts": [4]})", "/parts/0"},
        {R"({"hachure_style": 1, "parts": [{"name": 4}]})", "/parts/0/name"},
        {R"({"hachure_style": 1, "parts": [{}, {"implicit_brush": {"size": -1}}]})", "/parts/1/implicit_brush/size"},
        {R"({"hachure_style": 2})", "/hachure_style"},
        {R"({"name": "mine"})", "hachure_style"},
        {R"([1])", "hachure_style"},
        {R"({"hachure_style": 1,)", "(line 1, column "},
        {"", "(line 1, column "}};
    for (const auto& [json, place] : cases) {
        const std::string fault = fault_of(json);
        EXPECT_THAT(fault, ::testing::StartsWith("mine.json: ")) << json;
        EXPECT_THAT(fault, HasSubstr(place)) << json;
        EXPECT_EQ(fault.find('\n'), std::string::npos) << json;
    }
}

TEST_F(StyleTest, ASurfaceKeepsItsMesh) {
    World world;
    const Entity entity = world.create_with(Surface{.mesh = 7, .visible = false});
    apply_style(
        world, app.types(),
        parse_style(app.types(), "mine.json", R"({"hachure_style": 1, "surface": {"surface": {"tint": [1, 0, 0]}}})"));
    EXPECT_EQ(world.get<Surface>(entity), (Surface{.mesh = 7, .tint = {1, 0, 0}}));
}

TEST_F(StyleTest, AnUnknownStyleIsRefusedWithTheNamesThereAre) {
    try {
        static_cast<void>(find_style(app.types(), "watercolour"));
        FAIL() << "found";
    } catch (const Error& error) {
        EXPECT_THAT(error.what(), HasSubstr("gooch"));
    }
    EXPECT_THROW(static_cast<void>(find_style(app.types(), "no/such/file.json")), Error);
}

} // namespace
} // namespace hachure
