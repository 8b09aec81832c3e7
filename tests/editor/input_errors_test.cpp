#include <hachure/tests/editor/forked_command.h>
#include <hachure/tests/editor/program.h>
#include <hachure/tests/support/glb_file.h>

#include <unistd.h>

namespace hachure::test {
namespace {

/// Both commands that read a model fail with 1, name the file, and leave the folder as it was.
void expect_refused(const TempFolder& folder, const std::string& input, const std::string& says) {
    const auto before = folder.listing();
    EXPECT_TRUE(failed(forked_command({"info", input}, folder.path()), 1, input + ": " + says));
    EXPECT_TRUE(failed(forked_command({"render", input, "-o", "out.png", "--size", "64x48"}, folder.path()), 1,
                       input + ": " + says));
    EXPECT_EQ(folder.listing(), before);
}

TEST(InputErrors, MissingFile) {
    const TempFolder folder;
    expect_refused(folder, "absent.obj", "there is no such file");
    expect_refused(folder, "absent.glb", "there is no such file");
}

TEST(InputErrors, Folder) {
    const TempFolder folder;
    std::filesystem::create_directory(folder / "model.obj");
    std::filesystem::create_directory(folder / "folder");
    expect_refused(folder, "model.obj", "is a folder");
    expect_refused(folder, "folder", "is a folder");
}

TEST(InputErrors, UnreadableFile) {
    if (::geteuid() == 0) GTEST_SKIP() << "root reads every file";
    const TempFolder folder;
    for (const char* name : {"in.obj", "in.glb"}) {
        std::filesystem::permissions(folder.write(name, tetrahedron_obj), std::filesystem::perms::none);
        expect_refused(folder, name, "");
    }
}

TEST(InputErrors, EmptyFile) {
    const TempFolder folder;
    for (const std::string name : {"e.obj", "e.ply", "e.off", "e.stl", "e.glb", "e.gltf"}) {
        folder.write(name, "");
        const auto before = folder.listing();
        EXPECT_TRUE(failed(forked_command({"render", name, "-o", "out.png"}, folder.path()), 1, name + ": "));
        EXPECT_EQ(folder.listing(), before);
    }
}

TEST(InputErrors, MeshWithoutTriangles) {
    const TempFolder folder;
    folder.write("points.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n");
    folder.write("none.glb", edited_triangle_glb("\"mesh\": 0", "\"name\": \"n\""));
    for (const std::string name : {"points.obj", "none.glb"}) {
        const auto before = folder.listing();
        EXPECT_TRUE(failed(forked_command({"render", name, "-o", "out.png"}, folder.path()), 1, name + ": "));
        EXPECT_EQ(folder.listing(), before);
    }
}

TEST(InputErrors, UnknownKindOfFile) {
    const TempFolder folder;
    folder.write("notes.txt", "hello");
    expect_refused(folder, "notes.txt", "is not a kind of model");
}

TEST(InputErrors, NoImage) {
    const TempFolder folder;
    folder.write("in.png", "no image at all");
    EXPECT_TRUE(failed(forked_command({"render", "in.png", "-o", "out.png"}, folder.path()), 1, "in.png: "));
    EXPECT_TRUE(failed(forked_command({"info", "in.png"}, folder.path()), 1, "in.png: "));
    EXPECT_FALSE(std::filesystem::exists(folder / "out.png"));
}

TEST(InputErrors, NameWithControlCharactersStaysOneLine) {
    const TempFolder folder;
    EXPECT_TRUE(
        failed(forked_command({"info", "two\nlines.obj"}, folder.path()), 1, "lines.obj: there is no such file"));
}

TEST(InputErrors, BrokenPreset) {
    const TempFolder folder;
    folder.write("in.obj", tetrahedron_obj);
    folder.write("json.json", "{ \"hachure_style\": 1, ");
    folder.write("field.json", R"({"hachure_style": 1, "surface": {"gooch": {"blue": 1}}})");
    folder.write("range.json", R"({"hachure_style": 1, "surface": {"gooch": {"b": 7}}})");
    folder.write("version.json", R"({"hachure_style": 2})");
    folder.write("deep.json", std::string(1 << 19, '['));
    folder.write("types.json", R"({"hachure_style": 1, "name": [1], "surface": {"gooch": {"b": {"c": null}}}})");
    const auto before = folder.listing();
    for (const char* style :
         {"json.json", "field.json", "range.json", "version.json", "deep.json", "types.json", "absent.json"})
        EXPECT_TRUE(failed(forked_command({"render", "in.obj", "-o", "out.png", "--style", style}, folder.path()), 1,
                           std::string(style) + ": "))
            << style;
    EXPECT_EQ(folder.listing(), before);
}

TEST(InputErrors, SetThatNobodyCarries) {
    const TempFolder folder;
    folder.write("in.obj", tetrahedron_obj);
    const auto before = folder.listing();
    EXPECT_TRUE(
        failed(forked_command({"render", "in.obj", "-o", "out.png", "--set", "nobody/gooch.b=0.5"}, folder.path()), 1,
               "nobody"));
    EXPECT_EQ(folder.listing(), before);
}

} // namespace
} // namespace hachure::test
