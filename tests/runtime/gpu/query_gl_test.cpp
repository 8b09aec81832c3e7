#include <hachure/runtime/gpu/query.h>
#include <hachure/runtime/gpu/texture.h>
#include <hachure/tests/support/gl_fixture.h>

#include <chrono>

namespace hachure::gpu {
namespace {

using QueryTest = test::GlTest;

void work() {
    Texture texture({512, 512, Format::rgba32f}, "work");
    for (int i = 0; i < 8; ++i) texture.clear(std::array{0.5f, 0.5f, 0.5f, 0.5f});
    (void)texture.read_floats();
}

TEST_P(QueryTest, TimesWhatLiesBetween) {
    TimerQuery timer("timer");
    EXPECT_FALSE(timer.ready());
    EXPECT_FALSE(timer.try_milliseconds().has_value());
    const auto start = std::chrono::steady_clock::now();
    timer.begin();
    EXPECT_FALSE(timer.ready());
    work();
    timer.end();
    const double gpu = timer.milliseconds();
    const std::chrono::duration<double, std::milli> wall = std::chrono::steady_clock::now() - start;
    EXPECT_TRUE(timer.ready());
    EXPECT_EQ(timer.try_milliseconds(), gpu);
    EXPECT_GT(gpu, 0.0);
    EXPECT_LE(gpu, wall.count() * 1.1 + 1.0);
    timer.begin(); // the same query serves again
    timer.end();
    EXPECT_LT(timer.milliseconds(), gpu);
}

TEST_P(QueryTest, TimestampsEncloseTimers) {
    Timestamp before("before"), after("after");
    TimerQuery timer("between");
    EXPECT_FALSE(before.ready());
    before.record();
    timer.begin();
    work();
    timer.end();
    after.record();
    const double between = after.milliseconds() - before.milliseconds();
    EXPECT_TRUE(after.ready());
    // Clocks of a driver's counters may differ by a few microseconds.
    EXPECT_GE(between + 0.1, timer.milliseconds());
}

TEST_P(QueryTest, MisuseIsAnAssertion) {
    TimerQuery timer("timer");
    EXPECT_DEATH(timer.end(), "ends before it begins");
    EXPECT_DEATH((void)timer.milliseconds(), "read before it ends");
    Timestamp stamp("stamp");
    EXPECT_DEATH((void)stamp.milliseconds(), "read before it is recorded");
}

TEST_P(QueryTest, MovesItsObject) {
    TimerQuery first("moved");
    const GLuint name = first.name();
    TimerQuery second = std::move(first);
    EXPECT_EQ(second.name(), name);
    second.begin();
    second.end();
    EXPECT_GE(second.milliseconds(), 0.0);
}

HACHURE_INSTANTIATE_GL_TESTS(QueryTest);

} // namespace
} // namespace hachure::gpu
