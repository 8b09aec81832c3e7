#include <hachure/runtime/error.h>
#include <hachure/runtime/gpu/shader_source.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace hachure::gpu {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using Line = ShaderSource::Line;

class ShaderSourceTest : public ::testing::Test {
protected:
    void SetUp() override {
        std::string pattern = (std::filesystem::temp_directory_path() / "hachure_shaders_XXXXXX").string();
        ASSERT_NE(mkdtemp(pattern.data()), nullptr);
        folder_ = pattern;
    }
    void TearDown() override { std::filesystem::remove_all(folder_); }

    void write(const std::string& name, std::string_view text) const {
        std::filesystem::create_directories((folder_ / name).parent_path());
        std::ofstream(folder_ / name, std::ios::binary) << text;
    }

    [[nodiscard]] ShaderFiles files() const { return ShaderFiles(folder_); }

    [[nodiscard]] ShaderSource load(const std::string& name, std::vector<ShaderDefine> defines = {}) const {
        return load_shader_source(files(), name, defines);
    }

    [[nodiscard]] std::string fault(const std::string& name) const {
        try {
            (void)load(name);
        } catch (const Error& error) {
            return error.what();
        }
        return "no error";
    }

    std::filesystem::path folder_;
};

TEST_F(ShaderSourceTest, KeepsAFileWithoutIncludes) {
    write("a.frag", "#version 450 core\nvoid main() {}");
    const ShaderSource source = load("a.frag");
    EXPECT_EQ(source.text, "#version 450 core\nvoid main() {}\n");
    EXPECT_THAT(source.files, ElementsAre("a.frag"));
    EXPECT_THAT(source.lines, ElementsAre(Line{0, 1}, Line{0, 2}));
}

TEST_F(ShaderSourceTest, PutsDefinesAfterTheVersion) {
    write("a.frag", "// why\n#version 450 core\nint x = N;\n");
    const ShaderSource source = load("a.frag", {{"N", "3"}, {"ON"}});
    EXPECT_EQ(source.text, "// why\n#version 450 core\n#define N 3\n#define ON 1\nint x = N;\n");
    EXPECT_THAT(source.lines, ElementsAre(Line{0, 1}, Line{0, 2}, Line{0, 2}, Line{0, 2}, Line{0, 3}));
}

TEST_F(ShaderSourceTest, LooksBesideTheFileFirstAndThenBelowTheRoot) {
    write("gooch/a.frag", "#version 450\n#include \"local.glsl\"\n#include \"common/shared.glsl\"\nend\n");
    write("gooch/local.glsl", "beside\n");
    write("local.glsl", "not this one\n");
    write("common/shared.glsl", "\nshared\n");
    const ShaderSource source = load("gooch/a.frag");
    EXPECT_EQ(source.text, "#version 450\nbeside\n\nshared\nend\n");
    EXPECT_THAT(source.files, ElementsAre("gooch/a.frag", "gooch/local.glsl", "common/shared.glsl"));
    EXPECT_THAT(source.lines, ElementsAre(Line{0, 1}, Line{1, 1}, Line{2, 1}, Line{2, 2}, Line{0, 4}));
}

TEST_F(ShaderSourceTest, PutsAFileInOnce) {
    write("a.frag", "#version 450\n#include \"x.glsl\"\n#include \"y.glsl\"\n");
    write("x.glsl", "#include \"z.glsl\"\nx\n");
    write("y.glsl", "#include \"z.glsl\"\n#include \"./z.glsl\"\ny\n");
    write("z.glsl", "z\n");
    const ShaderSource source = load("a.frag");
    EXPECT_THAT(source.files, ElementsAre("a.frag", "x.glsl", "z.glsl", "y.glsl"));
    EXPECT_EQ(source.text.find("z\n"), source.text.rfind("z\n"));
}

TEST_F(ShaderSourceTest, LeavesCommentedIncludesAlone) {
    write("a.frag", "#version 450\n// #include \"no.glsl\"\n/*\n#include \"no.glsl\"\n*/ int a; // /*\n"
                    "  #  include \"yes.glsl\" // reason\n#included\n");
    write("yes.glsl", "yes\n");
    EXPECT_THAT(load("a.frag").files, ElementsAre("a.frag", "yes.glsl"));
}

TEST_F(ShaderSourceTest, NamesFileAndLineOfAMissingInclude) {
    write("gooch/a.frag", "#version 450\n#include \"b.glsl\"\n");
    write("gooch/b.glsl", "\n\n#include \"nowhere.glsl\"\n");
    EXPECT_EQ(fault("gooch/a.frag"), "gooch/b.glsl: there is no \"nowhere.glsl\" to include (line 3)");
    EXPECT_EQ(fault("none.frag"), "none.frag: there is no such shader");
}

TEST_F(ShaderSourceTest, RefusesCycles) {
    write("a.frag", "#version 450\n#include \"b.glsl\"\n");
    write("b.glsl", "#include \"c.glsl\"\n");
    write("c.glsl", "\n#include \"b.glsl\"\n");
    EXPECT_EQ(fault("a.frag"), "c.glsl: the includes form a cycle: b.glsl -> c.glsl -> b.glsl (line 2)");
    write("self.frag", "#version 450\n#include \"self.frag\"\n");
    EXPECT_THAT(fault("self.frag"), HasSubstr("cycle: self.frag -> self.frag (line 2)"));
}

TEST_F(ShaderSourceTest, RefusesPathsThatLeaveTheRoot) {
    write("s/a.frag", "#version 450\n#include \"../../secret\"\n");
    EXPECT_EQ(fault("s/a.frag"), "s/a.frag: \"../../secret\" leaves the shader directory (line 2)");
    write("s/b.frag", "#version 450\n#include \"/etc/passwd\"\n");
    EXPECT_THAT(fault("s/b.frag"), HasSubstr("leaves the shader directory (line 2)"));
    write("s/c.frag", "#version 450\n#include \"../ok.glsl\"\n");
    write("ok.glsl", "ok\n");
    EXPECT_THAT(load("s/c.frag").files, ElementsAre("s/c.frag", "ok.glsl"));
}

TEST_F(ShaderSourceTest, RefusesMalformedFiles) {
    write("a.frag", "#version 450\n#include <x.glsl>\n");
    EXPECT_EQ(fault("a.frag"), "a.frag: an #include needs a path in double quotes (line 2)");
    write("b.frag", "void main() {}\n");
    EXPECT_EQ(fault("b.frag"), "b.frag: the shader has no #version");
    write("c.frag", "#version 450\n#include \"d.glsl\"\n");
    write("d.glsl", "\n#version 450\n");
    EXPECT_EQ(fault("c.frag"), "d.glsl: an included file has a #version (line 2)");
    write("e.frag", "#version 450\n/* open\n");
    EXPECT_EQ(fault("e.frag"), "e.frag: a /* comment is not closed");
    write("big.frag", std::string((1u << 20) + 1, ' '));
    EXPECT_THAT(fault("big.frag"), HasSubstr("larger than 1 MiB"));
}

TEST_F(ShaderSourceTest, TellsEveryNameItLooksFor) {
    write("s/a.frag", "#version 450\n#include \"b.glsl\"\n#include \"gone.glsl\"\n");
    write("b.glsl", "b\n");
    std::vector<std::string> names;
    EXPECT_THROW((void)load_shader_source(files(), "s/a.frag", {}, [&](const auto& name) { names.push_back(name); }),
                 Error);
    EXPECT_THAT(names, ElementsAre("s/a.frag", "s/b.glsl", "b.glsl", "s/gone.glsl", "gone.glsl"));
}

TEST_F(ShaderSourceTest, ReadsEmbeddedFilesUnlessTheDirectoryHasThem) {
    const std::string name = "common/full_screen.vert";
    const auto embedded = ShaderFiles().read(name);
    ASSERT_TRUE(embedded.has_value());
    std::ifstream file(std::string(HACHURE_SOURCE_DIR "/shaders/") + name, std::ios::binary);
    EXPECT_EQ(*embedded, std::string(std::istreambuf_iterator<char>(file), {}));
    EXPECT_EQ(files().read(name), embedded);
    EXPECT_FALSE(files().stamp(name).exists);
    write(name, "mine");
    EXPECT_EQ(files().read(name), "mine");
    EXPECT_TRUE(files().stamp(name).exists);
    EXPECT_FALSE(files().read("common").has_value());
}

TEST_F(ShaderSourceTest, FindsItsDirectoryInTheEnvironment) {
    write("a.glsl", "from the environment");
    setenv("HACHURE_SHADERS", folder_.c_str(), 1);
    EXPECT_EQ(ShaderFiles::from_environment().read("a.glsl"), "from the environment");
    setenv("HACHURE_SHADERS", (folder_ / "none").c_str(), 1);
    EXPECT_THROW((void)ShaderFiles::from_environment(), Error);
    unsetenv("HACHURE_SHADERS");
    EXPECT_TRUE(ShaderFiles::from_environment().directory().empty());
}

/// Two lines of a shader around one of an included file.
const ShaderSource nested = {"a\nb\nc\n", {"gooch/gooch.frag", "common/light.glsl"}, {{0, 1}, {1, 7}, {0, 12}}};

TEST(ShaderLog, NamesPlacesInEveryCompilersForm) {
    EXPECT_EQ(readable_shader_log("0:3(5): error: `x' undeclared\n", nested),
              "gooch/gooch.frag:12: error: `x' undeclared");
    EXPECT_EQ(readable_shader_log("0(2) : error C1008: undefined variable \"x\"\n\n", nested),
              "common/light.glsl:7: error C1008: undefined variable \"x\"");
    EXPECT_EQ(readable_shader_log("ERROR: 0:2: 'x' : undeclared\nWARNING: 0:1: slow\r\n", nested),
              "common/light.glsl:7: error: 'x' : undeclared\ngooch/gooch.frag:1: warning: slow");
}

TEST(ShaderLog, KeepsLinesItDoesNotKnow) {
    EXPECT_EQ(readable_shader_log("0:4(1): error: past the end\n0:0(1): error: before it\n", nested),
              "0:4(1): error: past the end\n0:0(1): error: before it");
    EXPECT_EQ(readable_shader_log("99999999999999999999(1) : x\n: \n0(\nlinking failed", nested),
              "99999999999999999999(1) : x\n:\n0(\nlinking failed");
    EXPECT_EQ(readable_shader_log("", nested), "");
}

} // namespace
} // namespace hachure::gpu
