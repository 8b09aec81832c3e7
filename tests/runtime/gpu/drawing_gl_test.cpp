#include <hachure/runtime/error.h>
#include <hachure/runtime/gpu/framebuffer.h>
#include <hachure/runtime/gpu/full_screen.h>
#include <hachure/runtime/gpu/shader_library.h>
#include <hachure/runtime/gpu/state.h>
#include <hachure/runtime/gpu/vertex_array.h>
#include <hachure/tests/support/gl_fixture.h>

#include <gmock/gmock.h>

#include <initializer_list>
#include <string>

namespace hachure::gpu {
namespace {

using ::testing::Each;
using ::testing::ElementsAre;
using DrawingTest = test::GlTest;

constexpr std::array<float, 4> black = {0.0f, 0.0f, 0.0f, 0.0f};

Program make_program(const std::string& vertex, const std::string& fragment) {
    const std::array<ShaderStage, 2> stages = {
        {{GL_VERTEX_SHADER, {"#version 450 core\n" + vertex, {"test.vert"}, {}}},
         {GL_FRAGMENT_SHADER, {"#version 450 core\n" + fragment, {"test.frag"}, {}}}}};
    return Program(stages, "test");
}

const std::string full_screen_vertex = "void main() { vec2 c = vec2((gl_VertexID << 1) & 2, gl_VertexID & 2);"
                                       "gl_Position = vec4(c * 2 - 1, 0, 1); }";
const std::string uniform_color = "uniform vec4 value; out vec4 color; void main() { color = value; }";

/// Fills what `state` lets through with one colour.
void fill(const DrawState& state, const glm::vec4& value) {
    Program program = make_program(full_screen_vertex, uniform_color);
    program.set("value", value);
    program.use();
    apply(state);
    FullScreen().draw();
}

TEST_P(DrawingTest, FullScreenCopyIsExact) {
    ShaderLibrary library{{}};
    Program& copy = library.program({.vertex = "common/full_screen.vert", .fragment = "common/copy.frag"});
    constexpr int width = 37, height = 23;
    Texture source({width, height, Format::rgba32f}, "source");
    std::vector<float> values(static_cast<std::size_t>(width * height * 4));
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = std::sin(static_cast<float>(i)) * 100.0f;
    source.upload(values);
    Texture target({width, height, Format::rgba32f}, "target");
    const Framebuffer framebuffer({&target}, nullptr, "copy");
    framebuffer.bind();
    copy.use();
    copy.set("source", 4);
    source.bind(4);
    apply({.viewport = {0, 0, width, height}});
    FullScreen().draw();
    EXPECT_EQ(target.read_floats(), values);
}

TEST_P(DrawingTest, FullScreenUvRunsFromLowerLeftToUpperRight) {
    const auto source = load_shader_source(ShaderFiles(), "common/full_screen.vert");
    const std::array<ShaderStage, 2> stages = {
        {{GL_VERTEX_SHADER, source},
         {GL_FRAGMENT_SHADER,
          {"#version 450 core\nlayout(location = 0) in vec2 uv; out vec4 c; void main() { c = vec4(uv, 0, 1); }",
           {},
           {}}}}};
    const Program program(stages, "uv");
    Texture target({4, 2, Format::rg32f}, "target");
    const Framebuffer framebuffer({&target}, nullptr, "uv");
    framebuffer.bind();
    program.use();
    apply({.viewport = {0, 0, 4, 2}});
    FullScreen().draw();
    const std::vector<float> uv = target.read_floats(RowOrder::bottom_first);
    for (std::size_t y = 0; y < 2; ++y) {
        for (std::size_t x = 0; x < 4; ++x) {
            EXPECT_NEAR(uv[(y * 4 + x) * 2], (static_cast<double>(x) + 0.5) / 4.0, 1e-6);
            EXPECT_NEAR(uv[(y * 4 + x) * 2 + 1], (static_cast<double>(y) + 0.5) / 2.0, 1e-6);
        }
    }
}

TEST_P(DrawingTest, ViewportAndScissorConfine) {
    Texture target({3, 3, Format::r8}, "target");
    const Framebuffer framebuffer({&target}, nullptr, "areas");
    framebuffer.bind();
    apply({});
    framebuffer.clear_color(0, black);
    fill({.viewport = {1, 0, 2, 2}, .scissor = Rect{0, 1, 3, 2}}, glm::vec4(1.0f));
    EXPECT_THAT(target.read_bytes(RowOrder::bottom_first), ElementsAre(0, 0, 0, 0, 255, 255, 0, 0, 0));
    // Clears follow the scissor, and a state without one lifts it.
    framebuffer.clear_color(0, std::array{0.2f, 0.0f, 0.0f, 0.0f});
    EXPECT_THAT(target.read_bytes(RowOrder::bottom_first), ElementsAre(0, 0, 0, 51, 51, 51, 51, 51, 51));
    fill({.viewport = {0, 0, 3, 3}}, glm::vec4(1.0f));
    EXPECT_THAT(target.read_bytes(), Each(255));
}

TEST_P(DrawingTest, BlendsAsNamed) {
    struct Case {
        Blend blend;
        float rgb;
        float alpha;
    };
    // The target holds (0.5, 0.5, 0.5, 0.5); the source is (0.25, 0.25, 0.25, 0.75).
    const std::initializer_list<Case> cases = {
        {Blend::off, 0.25f, 0.75f},
        {Blend::alpha, 0.25f * 0.75f + 0.5f * 0.25f, 0.75f + 0.5f * 0.25f},
        {Blend::premultiplied, 0.25f + 0.5f * 0.25f, 0.75f + 0.5f * 0.25f},
        {Blend::add, 0.75f, 1.25f},
        {Blend::multiply, 0.125f, 0.375f},
        {Blend::min, 0.25f, 0.5f},
        {Blend::max, 0.5f, 0.75f},
    };
    Texture target({1, 1, Format::rgba32f}, "target");
    const Framebuffer framebuffer({&target}, nullptr, "blending");
    framebuffer.bind();
    for (const Case& test : cases) {
        framebuffer.clear_color(0, std::array{0.5f, 0.5f, 0.5f, 0.5f});
        fill({.viewport = {0, 0, 1, 1}, .blend = test.blend}, {0.25f, 0.25f, 0.25f, 0.75f});
        const std::vector<float> result = target.read_floats();
        EXPECT_FLOAT_EQ(result[0], test.rgb) << static_cast<int>(test.blend);
        EXPECT_FLOAT_EQ(result[3], test.alpha) << static_cast<int>(test.blend);
    }
}

TEST_P(DrawingTest, ColorWriteMasksShadersButNotClears) {
    Texture target({1, 1, Format::rgba8}, "target");
    const Framebuffer framebuffer({&target}, nullptr, "masks");
    framebuffer.bind();
    apply({});
    framebuffer.clear_color(0, black);
    fill({.viewport = {0, 0, 1, 1}, .color_write = {true, false, true, false}}, glm::vec4(1.0f));
    EXPECT_THAT(target.read_bytes(), ElementsAre(255, 0, 255, 0));
    framebuffer.clear_color(0, std::array{0.2f, 0.2f, 0.2f, 0.2f});
    EXPECT_THAT(target.read_bytes(), Each(51));
    fill({.viewport = {0, 0, 1, 1}, .color_write = {false, true, false, false}}, glm::vec4(1.0f));
    EXPECT_THAT(target.read_bytes(), ElementsAre(51, 255, 51, 51));
}

TEST_P(DrawingTest, DepthTestsAndWrites) {
    Texture color({1, 1, Format::r8}, "color"), depth({1, 1, Format::depth32f}, "depth");
    const Framebuffer framebuffer({&color}, &depth, "depth");
    framebuffer.bind();
    apply({});
    framebuffer.clear_color(0, black);
    framebuffer.clear_depth(0.25f);
    EXPECT_THAT(depth.read_floats(), ElementsAre(0.25f));
    const Rect view{0, 0, 1, 1};
    // The triangle lies at 0.5.
    fill({.viewport = view, .depth_test = DepthTest::less, .depth_write = true}, glm::vec4(1.0f));
    EXPECT_THAT(color.read_bytes(), ElementsAre(0));
    fill({.viewport = view, .depth_test = DepthTest::greater}, glm::vec4(0.2f));
    EXPECT_THAT(color.read_bytes(), ElementsAre(51));
    EXPECT_THAT(depth.read_floats(), ElementsAre(0.25f));
    fill({.viewport = view, .depth_test = DepthTest::always, .depth_write = true}, glm::vec4(1.0f));
    EXPECT_THAT(depth.read_floats(), ElementsAre(0.5f));
}

TEST_P(DrawingTest, SrgbTargetsEncodeWhenAsked) {
    Texture target({1, 1, Format::srgb8_alpha8}, "target");
    const Framebuffer framebuffer({&target}, nullptr, "srgb");
    framebuffer.bind();
    fill({.viewport = {0, 0, 1, 1}}, glm::vec4(0.5f));
    EXPECT_NEAR(target.read_bytes()[0], 128, 1);
    fill({.viewport = {0, 0, 1, 1}, .srgb_write = true}, glm::vec4(0.5f));
    EXPECT_NEAR(target.read_bytes()[0], 188, 1); // 255 * (1.055 * 0.5^(1/2.4) - 0.055)
    EXPECT_NEAR(target.read_bytes()[3], 128, 1);
}

TEST_P(DrawingTest, CullsByWinding) {
    Texture target({1, 1, Format::r8}, "target");
    const Framebuffer framebuffer({&target}, nullptr, "cull");
    framebuffer.bind();
    const auto drawn = [&](Cull cull) {
        framebuffer.clear_color(0, black);
        fill({.viewport = {0, 0, 1, 1}, .cull = cull}, glm::vec4(1.0f));
        return target.read_bytes()[0] == 255;
    };
    EXPECT_TRUE(drawn(Cull::none));
    EXPECT_TRUE(drawn(Cull::back)); // the full-screen triangle is counter-clockwise
    EXPECT_FALSE(drawn(Cull::front));
    EXPECT_TRUE(drawn(Cull::none));
}

TEST_P(DrawingTest, DrawsIndexedVerticesOfEveryKind) {
    struct Vertex {
        float position[2];
        std::uint8_t shade[4];
        std::uint32_t id;
    };
    const std::array<Vertex, 4> vertices = {{{{-1, -1}, {255, 0, 0, 255}, 7},
                                             {{1, -1}, {255, 0, 0, 255}, 7},
                                             {{1, 1}, {255, 0, 0, 255}, 7},
                                             {{-1, 1}, {255, 0, 0, 255}, 7}}};
    const std::array<std::uint16_t, 6> indices = {0, 1, 2, 0, 2, 3};
    const std::array<float, 2> per_instance = {0.25f, 0.5f};
    const Buffer vertex_buffer(std::span<const Vertex>(vertices), "vertices");
    const Buffer index_buffer(std::span<const std::uint16_t>(indices), "indices");
    const Buffer instance_buffer(std::span<const float>(per_instance), "instances");
    VertexArray array("quad");
    array.set_attribute({.location = 0, .components = 2});
    array.set_attribute({.location = 1,
                         .components = 4,
                         .type = GL_UNSIGNED_BYTE,
                         .kind = AttributeKind::normalized,
                         .offset = offsetof(Vertex, shade)});
    array.set_attribute({.location = 2,
                         .components = 1,
                         .type = GL_UNSIGNED_INT,
                         .kind = AttributeKind::integer,
                         .offset = offsetof(Vertex, id)});
    array.set_attribute({.location = 3, .components = 1, .binding = 1});
    array.set_vertex_buffer(0, vertex_buffer, sizeof(Vertex));
    array.set_vertex_buffer(1, instance_buffer, sizeof(float), 0, 1);
    array.set_index_buffer(index_buffer);
    const Program program = make_program("layout(location=0) in vec2 p; layout(location=1) in vec4 s;"
                                         "layout(location=2) in uint i; layout(location=3) in float n;"
                                         "flat out vec4 v; void main() { v = vec4(s.r, s.g, float(i), n);"
                                         "gl_Position = vec4(p, 0, 1); }",
                                         "flat in vec4 v; out vec4 color; void main() { color = v; }");
    Texture target({2, 2, Format::rgba32f}, "target");
    const Framebuffer framebuffer({&target}, nullptr, "quad");
    framebuffer.bind();
    apply({.viewport = {0, 0, 2, 2}});
    program.use();
    array.bind();
    gl().DrawElementsInstanced(GL_TRIANGLES, 6, GL_UNSIGNED_SHORT, nullptr, 2);
    const std::vector<float> result = target.read_floats();
    for (std::size_t i = 0; i < result.size(); i += 4) {
        EXPECT_THAT(std::vector<float>(result.begin() + i, result.begin() + i + 4),
                    ElementsAre(1.0f, 0.0f, 7.0f, 0.5f));
    }
}

HACHURE_INSTANTIATE_GL_TESTS(DrawingTest);

} // namespace
} // namespace hachure::gpu
