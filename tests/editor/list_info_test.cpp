#include <hachure/tests/editor/forked_command.h>
#include <hachure/tests/editor/program.h>
#include <hachure/tests/support/glb_file.h>

#include <fstream>
#include <iterator>
#include <map>
#include <sstream>

namespace hachure::test {
namespace {

/// The text of `hachure list KIND`, a line each.
std::vector<std::string> list(const std::string& kind) {
    const TempFolder folder;
    const ProcessResult result = forked_command({"list", kind}, folder.path());
    EXPECT_TRUE(succeeded(result)) << kind;
    std::vector<std::string> lines;
    std::istringstream stream(result.out);
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

/// The line that starts with the name as a word.
std::string line_of(const std::vector<std::string>& lines, const std::string& name) {
    for (const std::string& line : lines)
        if (line.starts_with(name + " ")) return line;
    ADD_FAILURE() << "no line of " << name;
    return {};
}

TEST(List, Styles) { EXPECT_NE(line_of(list("styles"), "gooch").find("cool-to-warm"), std::string::npos); }

TEST(List, ComponentsWithTheirFields) {
    const std::vector<std::string> lines = list("components");
    for (const char* name : {"transform", "camera", "light", "surface", "gooch", "edge_lines", "compose"})
        line_of(lines, name);
    const std::string field = line_of(lines, "  yfov");
    EXPECT_NE(field.find("rad"), std::string::npos) << field;
    EXPECT_NE(field.find("default 0.6"), std::string::npos) << field;
    EXPECT_NE(line_of(lines, "  projection").find("perspective|orthographic"), std::string::npos);
}

TEST(List, TheReferencePageOfComponentsIsCurrent) {
    std::ifstream stream(HACHURE_SOURCE_DIR "/docs/components.md", std::ios::binary);
    const std::string page{std::istreambuf_iterator<char>(stream), {}};
    const TempFolder folder;
    const ProcessResult result = forked_command({"list", "components", "--markdown"}, folder.path());
    ASSERT_TRUE(succeeded(result));
    EXPECT_NE(result.out.find("| `yfov` | real, 32 bits | rad | 0.001 to 3.13 | `0.6` |"), std::string::npos);
    EXPECT_TRUE(page == result.out)
        << "renew it: build/release/hachure list components --markdown > docs/components.md";
}

TEST(List, ThePublishedSchemaIsCurrent) {
    const TempFolder folder;
    const ProcessResult result = forked_command({"list", "schema"}, folder.path());
    ASSERT_TRUE(succeeded(result));
    EXPECT_NE(result.out.find("\"hachure_scene\""), std::string::npos);
    EXPECT_TRUE(file_text(HACHURE_SOURCE_DIR "/docs/scene.schema.json") == result.out)
        << "renew it: build/release/hachure list schema > docs/scene.schema.json";
}

TEST(List, MarkdownIsForComponents) {
    const TempFolder folder;
    EXPECT_EQ(forked_command({"list", "styles", "--markdown"}, folder.path()).exit_code, 2);
}

TEST(List, Aovs) {
    const std::vector<std::string> lines = list("aovs");
    EXPECT_EQ(lines.size(), 27u);
    EXPECT_NE(line_of(lines, "velocity").find("velocity.X velocity.Y"), std::string::npos);
    EXPECT_NE(line_of(lines, "depth").find(" Z "), std::string::npos);
    EXPECT_NE(line_of(lines, "color").find("R G B"), std::string::npos);
    line_of(lines, "normal");
    line_of(lines, "object_id");
    line_of(lines, "line_layer");
    for (const char* name : {"shade_needed", "shade_delivered", "stroke_coverage"}) line_of(lines, name);
    line_of(lines, "hidden_lines");
    line_of(lines, "picture_tone");
    line_of(lines, "picture_normal");
    line_of(lines, "picture_depth");
}

TEST(List, SystemsInTheOrderOfTheirStages) {
    const std::vector<std::string> stages{"input",  "script", "animate",  "transform",
                                          "deform", "light",  "material", "render"};
    std::size_t last = 0;
    const std::vector<std::string> lines = list("systems");
    EXPECT_GE(lines.size(), 8u);
    for (const std::string& line : lines) {
        const auto stage = std::ranges::find(stages, line.substr(0, line.find(' ')));
        ASSERT_NE(stage, stages.end()) << line;
        EXPECT_GE(static_cast<std::size_t>(stage - stages.begin()), last) << line;
        last = static_cast<std::size_t>(stage - stages.begin());
    }
}

TEST(List, SystemsWithWhatTheyReadAndWrite) {
    const auto line = [lines = list("systems")](const std::string& name) {
        for (const std::string& each : lines)
            if (each.find(" " + name + " ") != std::string::npos) return each;
        return std::string();
    };
    EXPECT_TRUE(line("camera").ends_with(" reads Camera, Canvas, WorldTransform; writes View")) << line("camera");
    EXPECT_NE(line("edge_lines.select").find("; writes EdgeLineFrame, FrameRequests, LineLayer"), std::string::npos)
        << line("edge_lines.select");
    EXPECT_TRUE(line("transform").ends_with("; writes WorldTransform; queues commands")) << line("transform");
    EXPECT_TRUE(line("gooch.pass").ends_with(" anything; runs alone")) << line("gooch.pass");
}

/// The rows of `hachure info FILE`, by name.
std::map<std::string, std::string> info(const TempFolder& folder, const std::string& file) {
    const ProcessResult result = forked_command({"info", file}, folder.path());
    EXPECT_TRUE(succeeded(result));
    std::map<std::string, std::string> rows;
    std::istringstream stream(result.out);
    for (std::string line; std::getline(stream, line);) {
        std::string name = line.substr(0, 14);
        name.erase(name.find_last_not_of(' ') + 1);
        rows[name] = line.size() > 15 ? line.substr(15) : "";
    }
    return rows;
}

TEST(Info, ClosedMesh) {
    const TempFolder folder;
    folder.write("t.obj", tetrahedron_obj);
    auto rows = info(folder, "t.obj");
    EXPECT_EQ(rows["file"], "t.obj");
    EXPECT_EQ(rows["kind"], "model");
    EXPECT_EQ(rows["triangles"], "4");
    EXPECT_TRUE(rows["vertices"].ends_with("at 4 places")) << rows["vertices"];
    EXPECT_EQ(rows["bounds"], "-1 -1 -1 to 1 1 1");
    EXPECT_EQ(rows["components"], "1");
    EXPECT_EQ(rows["health"], "closed, oriented, manifold");
    EXPECT_EQ(rows["clips"], "0");
    EXPECT_EQ(rows["joints"], "0");
    EXPECT_EQ(rows["morph targets"], "0");
    EXPECT_EQ(rows["extensions"], "none");
    EXPECT_TRUE(rows["normals"].starts_with("computed")) << rows["normals"];
}

TEST(Info, FaultsOfAMesh) {
    const TempFolder folder;
    folder.write("open.obj", "v 1 1 1\nv 1 -1 -1\nv -1 1 -1\nv -1 -1 1\nf 1 2 3\nf 1 3 4\nf 1 4 2\n");
    const std::string open = info(folder, "open.obj")["health"];
    EXPECT_NE(open.find("1 hole"), std::string::npos) << open;
    EXPECT_NE(open.find("3 boundary edges"), std::string::npos) << open;
    folder.write("fin.obj", std::string(tetrahedron_obj) + "v 5 0 0\nf 1 2 5\n");
    const std::string fin = info(folder, "fin.obj")["health"];
    EXPECT_NE(fin.find("1 non-manifold edges"), std::string::npos) << fin;
    folder.write("flip.obj", "v 1 1 1\nv 1 -1 -1\nv -1 1 -1\nv -1 -1 1\nf 1 2 3\nf 1 3 4\nf 1 4 2\nf 2 3 4\n");
    const std::string flip = info(folder, "flip.obj")["health"];
    EXPECT_NE(flip.find("flipped"), std::string::npos) << flip;
}

TEST(Info, NodesAndCamerasOfAScene) {
    const TempFolder folder;
    folder.write("s.glb", two_squares_glb());
    auto rows = info(folder, "s.glb");
    EXPECT_EQ(rows["nodes"], "3 in 1 scenes");
    EXPECT_EQ(rows["cameras"], "1");
    EXPECT_EQ(rows["triangles"], "2");
    EXPECT_EQ(rows["bounds"], "-2 -1 0 to 2 1 0");
}

} // namespace
} // namespace hachure::test
