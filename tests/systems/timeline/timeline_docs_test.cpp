// docs/timelines.md shows what is read.

#include <hachure/components/camera.h>
#include <hachure/components/light.h>
#include <hachure/runtime/assets/json_text.h>
#include <hachure/systems/animation/animation.h>
#include <hachure/systems/model/spawn_model.h>
#include <hachure/tests/support/arm_model.h>
#include <hachure/tests/systems/timeline/timeline_scene.h>

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

namespace hachure::test {
namespace {

struct Example {
    std::string part, text;
};

/// The blocks that begin with "```json PART".
std::vector<Example> examples() {
    std::ifstream stream(std::filesystem::path(HACHURE_SOURCE_DIR) / "docs/timelines.md");
    const std::string page{std::istreambuf_iterator<char>(stream), {}};
    std::vector<Example> result;
    const std::string open = "```json ";
    for (std::size_t at = page.find(open); at != page.npos; at = page.find(open, at)) {
        const std::size_t line = page.find('\n', at), end = page.find("\n```", line);
        result.push_back({page.substr(at + open.size(), line - at - open.size()), page.substr(line, end - line)});
        at = end;
    }
    return result;
}

TEST(TimelineDocs, ExamplesAreRead) {
    TimelineScene scene;
    register_animation(scene.app);
    scene.app.add_component<Camera>();
    scene.app.add_component<Light>();
    const Entity root = spawn_model(scene.world(), arm_model()).root;
    const std::vector<Example> all = examples();
    EXPECT_EQ(all.size(), 7u);
    for (const Example& example : all) {
        const ScenePart* part = scene.world().resource<SceneParts>().find(example.part);
        ASSERT_TRUE(part) << example.part;
        const assets::JsonText text = assets::JsonText::parse("timelines.md", example.text);
        EXPECT_NO_THROW(part->read(scene.world(), root, {text, "", text.root(), scene.app.types(), {}, scene.warnings}))
            << example.text;
        EXPECT_EQ(part->write(scene.world(), root), text.root());
    }
    for (const std::string& warning : scene.warnings) ADD_FAILURE() << warning;
}

} // namespace
} // namespace hachure::test
