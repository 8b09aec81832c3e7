#include <hachure/runtime/gpu/framebuffer.h>
#include <hachure/runtime/gpu/full_screen.h>
#include <hachure/runtime/gpu/program.h>
#include <hachure/runtime/gpu/query.h>
#include <hachure/runtime/gpu/state.h>
#include <hachure/tests/support/gl_fixture.h>

#include <chrono>

namespace hachure::gpu {
namespace {

/// Draws that take long enough to be measured, into either of two framebuffers.
class Work {
public:
    Work() { draw(0, 1); } // the driver compiles at the first draw

    void draw(std::size_t target, int effort) {
        framebuffers_[target].bind();
        apply({.viewport = {0, 0, side, side}});
        program_.use();
        program_.set("effort", effort);
        full_screen_.draw();
    }

private:
    static constexpr int side = 128;

    static Program compile() {
        const std::string text = "#version 450 core\nuniform int effort; out vec4 c; void main() { float s = 0.0;"
                                 "for (int i = 0; i < effort; ++i) s += sin(gl_FragCoord.x * i); c = vec4(s); }\n";
        const std::array<ShaderStage, 2> stages = {
            {{GL_VERTEX_SHADER, load_shader_source(ShaderFiles(), "common/full_screen.vert")},
             {GL_FRAGMENT_SHADER, {text, {}, {}}}}};
        return Program(stages, "work");
    }

    Program program_ = compile();
    FullScreen full_screen_;
    std::array<Texture, 2> textures_ = {Texture({side, side, Format::r32f}, "0"),
                                        Texture({side, side, Format::r32f}, "1")};
    std::array<Framebuffer, 2> framebuffers_ = {Framebuffer({&textures_[0]}, nullptr, "0"),
                                                Framebuffer({&textures_[1]}, nullptr, "1")};
};

/// Milliseconds of the wall clock that `calls` and the GPU's work for them take.
template <typename Calls> double wall_milliseconds(const Calls& calls) {
    gl().Finish();
    const auto start = std::chrono::steady_clock::now();
    calls();
    gl().Finish();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

using QueryTest = test::GlTest;

TEST_P(QueryTest, IsReadyAfterItsEndAlone) {
    TimerQuery timer("timer");
    EXPECT_FALSE(timer.ready());
    EXPECT_FALSE(timer.try_milliseconds().has_value());
    timer.begin();
    EXPECT_FALSE(timer.ready());
    timer.end();
    const double time = timer.milliseconds();
    EXPECT_TRUE(timer.ready());
    EXPECT_EQ(timer.try_milliseconds(), time);
}

TEST_P(QueryTest, TimesDrawsIntoSeveralFramebuffers) {
    Work work;
    TimerQuery all("all"), first("first"), second("second");
    const double wall = wall_milliseconds([&] {
        all.begin();
        first.begin();
        work.draw(0, 400);
        first.end();
        second.begin();
        work.draw(1, 100);
        second.end();
        all.end();
    });
    EXPECT_LE(all.milliseconds(), wall * 1.05 + 0.1);
    // All of it is seen: the parts, and not only what followed the change of framebuffer.
    EXPECT_GE(all.milliseconds() + 0.1, first.milliseconds() + second.milliseconds());
    EXPECT_GT(first.milliseconds(), 0.0);
    EXPECT_GT(all.milliseconds(), second.milliseconds());
    first.begin(); // the same timer serves again
    first.end();
    EXPECT_LT(first.milliseconds(), all.milliseconds());
}

TEST_P(QueryTest, TimestampsGrow) {
    Work work;
    Timestamp before("before"), after("after");
    EXPECT_FALSE(before.ready());
    before.record();
    work.draw(0, 100);
    after.record();
    EXPECT_GT(after.nanoseconds(), before.nanoseconds());
    EXPECT_TRUE(after.ready());
}

TEST_P(QueryTest, MisuseIsAnAssertion) {
    TimerQuery timer("timer");
    EXPECT_DEATH(timer.end(), "ends before it begins");
    EXPECT_DEATH((void)timer.milliseconds(), "read before it ends");
    const Timestamp stamp("stamp");
    EXPECT_DEATH((void)stamp.nanoseconds(), "read before it is recorded");
}

TEST_P(QueryTest, MovesItsObject) {
    Timestamp first("moved");
    const GLuint name = first.name();
    Timestamp second = std::move(first);
    EXPECT_EQ(second.name(), name);
    second.record();
    EXPECT_GT(second.nanoseconds(), 0u);
}

HACHURE_INSTANTIATE_GL_TESTS(QueryTest);

} // namespace
} // namespace hachure::gpu
