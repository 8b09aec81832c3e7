#include <hachure/runtime/app/app.h>
#include <hachure/systems/capabilities.h>
#include <hachure/tests/editor/program.h>
#include <hachure/tests/support/glb_file.h>

#include <nlohmann/json.hpp>

#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace hachure::test {
namespace {

using nlohmann::json;

/// The keys of an object, to compare with those that the format promises.
std::set<std::string> keys(const json& object) {
    std::set<std::string> result;
    for (const auto& [key, value] : object.items()) result.insert(key);
    return result;
}

class Stats : public testing::Test {
protected:
    json render(const std::vector<std::string>& more) {
        const TempFolder folder;
        folder.write("in.glb", two_squares_glb());
        std::vector<std::string> arguments{"render", "in.glb", "-o", "out.png", "--size", "64x32", "--stats", "s.json"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const ProcessResult result = hachure_program(folder, arguments);
        EXPECT_EQ(result.exit_code, 0) << result.err; // notes about the mesh may be there
        return json::parse(file_text(folder / "s.json"), nullptr, false);
    }
};

TEST_F(Stats, FollowsItsFormat) {
    const json stats = render({});
    ASSERT_TRUE(stats.is_object());
    EXPECT_EQ(keys(stats), (std::set<std::string>{"frames", "memory"}));
    ASSERT_EQ(stats["frames"].size(), 1u);
    const json& frame = stats["frames"][0];
    EXPECT_EQ(keys(frame), (std::set<std::string>{"ms", "systems", "passes", "counts"}));
    EXPECT_GT(frame["ms"].get<double>(), 0.0);
    for (const json& system : frame["systems"]) {
        EXPECT_EQ(keys(system), (std::set<std::string>{"name", "ms"}));
        EXPECT_GE(system["ms"].get<double>(), 0.0);
    }
    for (const json& pass : frame["passes"]) {
        EXPECT_EQ(keys(pass), (std::set<std::string>{"name", "state", "cpu_ms", "gpu_ms", "pixels", "bytes"}));
        const std::string state = pass["state"];
        EXPECT_TRUE(state == "run" || state == "reused" || state == "culled") << state;
        EXPECT_GE(pass["cpu_ms"].get<double>(), 0.0);
        EXPECT_TRUE(pass["gpu_ms"].is_number() || pass["gpu_ms"].is_null());
        if (state == "run") {
            EXPECT_GT(pass["pixels"].get<double>(), 0.0) << pass["name"];
        }
    }
    for (const auto& [name, count] : frame["counts"].items()) EXPECT_TRUE(count.is_number_unsigned()) << name;
    for (const auto& [name, bytes] : stats["memory"].items()) EXPECT_TRUE(bytes.is_number_unsigned()) << name;
}

/// Also of those that ran beside others.
TEST_F(Stats, HasATimeForEverySystem) {
    App app;
    register_capabilities(app);
    for (const char* threads : {"1", "4"}) {
        const json systems = render({"--threads", threads})["frames"][0]["systems"];
        std::vector<std::string> names;
        for (const json& system : systems) {
            names.push_back(system["name"]);
            EXPECT_GT(system["ms"].get<double>(), 0.0) << system["name"] << " with " << threads << " threads";
        }
        const std::vector<std::string_view> all = app.schedule().names();
        EXPECT_EQ(names, std::vector<std::string>(all.begin(), all.end()));
    }
}

TEST_F(Stats, CountsWhatIsDrawn) {
    const json counts = render({})["frames"][0]["counts"];
    EXPECT_EQ(counts["surfaces_drawn"], 2);
    EXPECT_EQ(counts["triangles_drawn"], 4);
    const json fewer = render({"--set", "left/surface.visible=false"})["frames"][0]["counts"];
    EXPECT_EQ(fewer["surfaces_drawn"], 1);
    EXPECT_EQ(fewer["triangles_drawn"], 2);
    EXPECT_EQ(fewer["shade_segments"], 0);
}

TEST_F(Stats, CountsShadeStrokes) {
    const auto counts = [&](const char* frame) {
        return render({"--style", "strokes", "--frames", frame})["frames"][0]["counts"];
    };
    const json first = counts("0"), later = counts("1");
    EXPECT_EQ(first["shade_triangles_swept"], 4);
    for (const char* name : {"shade_triangles_touched", "shade_chains", "shade_segments", "shade_vertices"})
        EXPECT_GT(first[name], 0) << name;
    EXPECT_EQ(later["shade_segments"], first["shade_segments"]);
    for (const char* name : {"shade_triangles_swept", "shade_triangles_touched"}) EXPECT_EQ(later[name], 0) << name;
}

TEST_F(Stats, NamesThePassesOfTheStyle) {
    std::set<std::string> names;
    const json stats = render({});
    for (const json& pass : stats["frames"][0]["passes"])
        if (pass["state"] == "run") names.insert(pass["name"]);
    EXPECT_TRUE(names.contains("gooch"));
    EXPECT_TRUE(names.contains("targets"));
    EXPECT_FALSE(names.contains("depth")) << "a pass that nobody asked for";
}

TEST_F(Stats, AnUndrawnSceneRunsNoShading) {
    const json stats = render({"--set", "surface.visible=false"});
    ASSERT_FALSE(stats["frames"][0]["passes"].empty());
    for (const json& pass : stats["frames"][0]["passes"]) EXPECT_NE(pass["name"], "gooch");
}

} // namespace
} // namespace hachure::test
