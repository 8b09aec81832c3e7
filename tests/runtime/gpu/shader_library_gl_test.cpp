#include <hachure/runtime/error.h>
#include <hachure/runtime/gpu/framebuffer.h>
#include <hachure/runtime/gpu/full_screen.h>
#include <hachure/runtime/gpu/shader_library.h>
#include <hachure/runtime/gpu/state.h>
#include <hachure/tests/support/gl_fixture.h>

#include <gmock/gmock.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace hachure::gpu {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::StartsWith;

class ShaderLibraryTest : public test::GlTest {
protected:
    void SetUp() override {
        test::GlTest::SetUp();
        if (IsSkipped()) return;
        std::string pattern = (std::filesystem::temp_directory_path() / "hachure_library_XXXXXX").string();
        ASSERT_NE(mkdtemp(pattern.data()), nullptr);
        folder_ = pattern;
    }
    void TearDown() override {
        if (!folder_.empty()) std::filesystem::remove_all(folder_);
        test::GlTest::TearDown();
    }

    /// Writes a file, a second younger than the last one: edits of a test are faster than some file systems' clocks.
    void write(const std::string& name, const std::string& text) {
        std::ofstream(folder_ / name, std::ios::binary) << text;
        time_ += std::chrono::seconds(1);
        std::filesystem::last_write_time(folder_ / name, time_);
    }

    /// The red that the program draws.
    static float draw(Program& program) {
        Texture target({1, 1, Format::r32f}, "target");
        const Framebuffer framebuffer({&target}, nullptr, "draw");
        framebuffer.bind();
        apply({.viewport = {0, 0, 1, 1}});
        program.use();
        FullScreen().draw();
        return target.read_floats()[0];
    }

    static std::string fault(ShaderLibrary& library, const ProgramSource& source) {
        try {
            (void)library.program(source);
        } catch (const Error& error) {
            return error.what();
        }
        return "no error";
    }

    std::filesystem::path folder_;
    std::filesystem::file_time_type time_ = std::filesystem::file_time_type::clock::now();
    const ProgramSource source_{.vertex = "common/full_screen.vert", .fragment = "a.frag"};
};

TEST_P(ShaderLibraryTest, CompilesOncePerKey) {
    write("a.frag", "#version 450 core\nout vec4 c; void main() { c = vec4(VALUE); }\n");
    ShaderLibrary library(folder_);
    ProgramSource two = source_, three = source_;
    two.defines = {{"VALUE", "2.0"}};
    three.defines = {{"VALUE", "3.0"}};
    Program& first = library.program(two);
    EXPECT_EQ(&library.program(two), &first);
    EXPECT_NE(&library.program(three), &first);
    EXPECT_EQ(draw(first), 2.0f);
    EXPECT_EQ(draw(library.program(three)), 3.0f);
    EXPECT_EQ(two.key(), "common/full_screen.vert+a.frag [VALUE=2.0]");
}

TEST_P(ShaderLibraryTest, CompileErrorsNameFileAndLine) {
    write("a.frag", "#version 450 core\n#include \"bad.glsl\"\nout vec4 c;\nvoid main() { c = vec4(bad()); }\n");
    write("bad.glsl", "// fine\nfloat bad() {\n    return missing;\n}\n");
    ShaderLibrary library(folder_);
    EXPECT_THAT(fault(library, source_), StartsWith("bad.glsl:3: error"));
    write("bad.glsl", "float bad() { return 1.0; }\n");
    write("a.frag", "#version 450 core\n#include \"bad.glsl\"\nout vec4 c;\nvoid main() { c = vec4(worse()); }\n");
    EXPECT_THAT(fault(library, source_), StartsWith("a.frag:4: error"));
    ProgramSource with_defines = source_;
    with_defines.defines = {{"A"}, {"B"}};
    EXPECT_THAT(fault(library, with_defines), StartsWith("a.frag:4: error"));
    write("a.frag", "#version 450 core\nvoid main() {\n");
    EXPECT_THAT(fault(library, source_), StartsWith("a.frag:")) << "the fault is at the end of the file";
}

TEST_P(ShaderLibraryTest, LinkErrorsNameTheProgram) {
    write("a.frag", "#version 450 core\nlayout(location = 0) in vec4 uv; out vec4 c; void main() { c = uv; }\n");
    ShaderLibrary library(folder_);
    EXPECT_THAT(fault(library, source_), StartsWith("common/full_screen.vert+a.frag: the program does not link: "));
}

TEST_P(ShaderLibraryTest, ReloadsWhatWasEdited) {
    write("a.frag", "#version 450 core\n#include \"value.glsl\"\nout vec4 c; void main() { c = vec4(value); }\n");
    write("b.frag", "#version 450 core\nout vec4 c; void main() { c = vec4(9.0); }\n");
    write("value.glsl", "const float value = 1.0;\n");
    ShaderLibrary library(folder_);
    Program& program = library.program(source_);
    const GLuint other = library.program({.vertex = source_.vertex, .fragment = "b.frag"}).name();
    EXPECT_FALSE(library.reload_changed());
    EXPECT_EQ(library.generation(), 0u);
    write("value.glsl", "const float value = 2.0;\n");
    EXPECT_TRUE(library.reload_changed());
    EXPECT_EQ(library.generation(), 1u);
    EXPECT_EQ(draw(program), 2.0f);
    EXPECT_EQ(&library.program(source_), &program);
    EXPECT_EQ(library.program({.vertex = source_.vertex, .fragment = "b.frag"}).name(), other);
    EXPECT_FALSE(library.reload_changed());
}

TEST_P(ShaderLibraryTest, KeepsTheOldProgramUntilTheNewOneIsRight) {
    write("a.frag", "#version 450 core\nout vec4 c; void main() { c = vec4(1.0); }\n");
    ShaderLibrary library(folder_);
    Program& program = library.program(source_);
    write("a.frag", "#version 450 core\n#include \"later.glsl\"\nout vec4 c; void main() { c = vec4(later); }\n");
    EXPECT_TRUE(library.reload_changed());
    EXPECT_THAT(library.errors(), ElementsAre("a.frag: there is no \"later.glsl\" to include (line 2)"));
    EXPECT_EQ(library.generation(), 0u);
    EXPECT_EQ(draw(program), 1.0f);
    EXPECT_FALSE(library.reload_changed()) << "the same fault is reported once";
    write("later.glsl", "const float later = oops;\n");
    EXPECT_TRUE(library.reload_changed());
    EXPECT_THAT(library.errors(), ElementsAre(StartsWith("later.glsl:1: error")));
    EXPECT_EQ(draw(program), 1.0f);
    write("later.glsl", "const float later = 3.0;\n");
    EXPECT_TRUE(library.reload_changed());
    EXPECT_THAT(library.errors(), IsEmpty());
    EXPECT_EQ(draw(program), 3.0f);
}

TEST_P(ShaderLibraryTest, ADirectorySetLaterOverridesTheEmbeddedFiles) {
    ShaderLibrary library{std::filesystem::path()};
    const ProgramSource copy{.vertex = "common/full_screen.vert", .fragment = "common/copy.frag"};
    Program& program = library.program(copy);
    std::filesystem::create_directories(folder_ / "common");
    write("common/copy.frag", "#version 450 core\nout vec4 c; void main() { c = vec4(4.0); }\n");
    library.set_directory(folder_);
    EXPECT_TRUE(library.reload_changed());
    EXPECT_EQ(draw(program), 4.0f);
    std::filesystem::remove(folder_ / "common/copy.frag");
    EXPECT_TRUE(library.reload_changed());
    EXPECT_TRUE(program.has_uniform("source")) << "the embedded file is back";
    EXPECT_THROW(library.set_directory(folder_ / "none"), Error);
}

TEST_P(ShaderLibraryTest, SetsUniformsOfEveryType) {
    write("a.frag",
          "#version 450 core\n"
          "uniform float f; uniform int i; uniform uint u; uniform bool b; uniform vec2 v2; uniform vec3 v3;\n"
          "uniform vec4 v4; uniform ivec2 i2; uniform uvec3 u3; uniform mat3 m3; uniform mat4 m4;\n"
          "uniform float fs[3]; uniform vec3 v3s[2]; uniform int is[2]; uniform mat4 m4s[2];\n"
          "out vec4 c;\n"
          "void main() { c = vec4(f + i + float(u) + (b ? 1 : 0) + v2.y + v3.z + v4.w + i2.y + float(u3.z)\n"
          "  + m3[2][1] + m4[3][0] + fs[2] + v3s[1].z + is[1] + m4s[1][2][3]); }\n");
    ShaderLibrary library(folder_);
    Program& program = library.program(source_);
    program.set("f", 0.5f);
    program.set("i", 1);
    program.set("u", 2u);
    program.set("b", true);
    program.set("v2", glm::vec2(0, 4));
    program.set("v3", glm::vec3(0, 0, 8));
    program.set("v4", glm::vec4(0, 0, 0, 16));
    program.set("i2", glm::ivec2(0, 32));
    program.set("u3", glm::uvec3(0, 0, 64));
    glm::mat3 m3(0.0f);
    m3[2][1] = 128.0f;
    program.set("m3", m3);
    glm::mat4 m4(0.0f);
    m4[3][0] = 256.0f;
    program.set("m4", m4);
    const std::array<float, 3> fs = {0, 0, 512};
    program.set("fs", std::span<const float>(fs));
    const std::array<glm::vec3, 2> v3s = {glm::vec3(0), glm::vec3(0, 0, 1024)};
    program.set("v3s", std::span<const glm::vec3>(v3s));
    const std::array<int, 2> is = {0, 2048};
    program.set("is", std::span<const int>(is));
    std::array<glm::mat4, 2> m4s = {glm::mat4(0.0f), glm::mat4(0.0f)};
    m4s[1][2][3] = 4096.0f;
    program.set("m4s", std::span<const glm::mat4>(m4s));
    program.set("not there", 1.0f);
    EXPECT_FALSE(program.has_uniform("not there"));
    EXPECT_TRUE(program.has_uniform("v3s"));
    EXPECT_EQ(draw(program), 8192.5f);
}

TEST_P(ShaderLibraryTest, RunsComputeShaders) {
    write("fill.comp", "#version 450 core\nlayout(local_size_x = 4) in;\n"
                       "layout(std430, binding = 1) buffer Out { uint values[]; };\n"
                       "void main() { values[gl_GlobalInvocationID.x] = gl_GlobalInvocationID.x * SCALE; }\n");
    ShaderLibrary library(folder_);
    Program& program = library.program({.compute = "fill.comp", .defines = {{"SCALE", "3"}}});
    const Buffer buffer(8 * sizeof(std::uint32_t), BufferUsage::immutable, "values");
    buffer.bind_base(BufferBinding::storage, 1);
    program.use();
    gl().DispatchCompute(2, 1, 1);
    gl().MemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    std::vector<std::uint32_t> values(8);
    buffer.read(std::span(values));
    EXPECT_THAT(values, ElementsAre(0, 3, 6, 9, 12, 15, 18, 21));
}

HACHURE_INSTANTIATE_GL_TESTS(ShaderLibraryTest);

} // namespace
} // namespace hachure::gpu
