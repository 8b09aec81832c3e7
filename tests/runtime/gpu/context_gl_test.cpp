#include <hachure/runtime/error.h>
#include <hachure/runtime/gpu/buffer.h>
#include <hachure/runtime/gpu/context.h>
#include <hachure/runtime/gpu/debug_messages.h>
#include <hachure/runtime/gpu/texture.h>
#include <hachure/tests/support/gl_fixture.h>

#include <gmock/gmock.h>

#include <array>
#include <thread>

namespace hachure::gpu {
namespace {

using ContextTest = test::GlTest;

TEST_P(ContextTest, SaysWhatItIs) {
    EXPECT_EQ(context().backend(), GetParam());
    EXPECT_FALSE(context().description().renderer.empty());
    EXPECT_THAT(context().description().summary(), ::testing::HasSubstr(context().description().version));
    if (GetParam() == Backend::osmesa) {
        EXPECT_TRUE(context().is_software());
    }
    EXPECT_EQ(context().window() != nullptr, GetParam() == Backend::glfw);
    RecordProperty("renderer", context().description().summary());
}

TEST_P(ContextTest, AllowsWhatOpenGl45Promises) {
    const ContextLimits& limits = context().limits();
    EXPECT_GE(limits.max_texture_size, 16384);
    EXPECT_GE(limits.max_viewport_width, 16384);
    EXPECT_GE(limits.max_viewport_height, 16384);
    EXPECT_GE(limits.max_color_attachments, 8);
    EXPECT_GE(limits.max_draw_buffers, 8);
    EXPECT_GE(limits.max_texture_units, 96);
    EXPECT_GE(limits.max_samples, 1);
    EXPECT_GE(limits.max_uniform_block_bytes, 16384);
    EXPECT_GE(limits.max_storage_block_bytes, 1 << 24);
    EXPECT_GE(limits.max_anisotropy, 1.0f);
}

TEST_P(ContextTest, IsCurrentUntilReleased) {
    EXPECT_EQ(Context::current(), &context());
    Context::release_current();
    EXPECT_EQ(Context::current(), nullptr);
    EXPECT_FALSE(has_gl());
    context().make_current();
    EXPECT_TRUE(has_gl());
    EXPECT_NE(gl().GetString(GL_VERSION), nullptr);
}

TEST_P(ContextTest, TurnsWrongCallsIntoErrors) {
    gl().Enable(0xDEAD);
    try {
        check_debug_messages();
        FAIL() << "the wrong call went unnoticed";
    } catch (const Error& error) {
        EXPECT_THAT(error.what(), ::testing::StartsWith("OpenGL: "));
        EXPECT_THAT(error.what(), ::testing::HasSubstr("GL_INVALID_ENUM"));
    }
    EXPECT_NO_THROW(check_debug_messages());
}

TEST_P(ContextTest, DropsNotificationsAndGroups) {
    {
        const DebugGroup group("a group");
        gl().DebugMessageInsert(GL_DEBUG_SOURCE_APPLICATION, GL_DEBUG_TYPE_MARKER, 1, GL_DEBUG_SEVERITY_NOTIFICATION, 2,
                                "hi");
    }
    EXPECT_TRUE(context().debug_messages().take().empty());
}

TEST_P(ContextTest, KeepsMessagesThatAreNoErrors) {
    gl().DebugMessageInsert(GL_DEBUG_SOURCE_APPLICATION, GL_DEBUG_TYPE_PERFORMANCE, 7, GL_DEBUG_SEVERITY_MEDIUM, 4,
                            "slow");
    const auto messages = context().debug_messages().take();
    ASSERT_EQ(messages.size(), 1u);
    EXPECT_EQ(messages[0].text, "slow");
    EXPECT_EQ(messages[0].id, 7u);
    EXPECT_FALSE(DebugMessages::is_error(messages[0]));
}

TEST_P(ContextTest, KeepsABoundedNumberOfMessages) {
    for (std::size_t i = 0; i < DebugMessages::capacity + 10; ++i) {
        gl().DebugMessageInsert(GL_DEBUG_SOURCE_APPLICATION, GL_DEBUG_TYPE_OTHER, 1, GL_DEBUG_SEVERITY_MEDIUM, 1, "x");
    }
    EXPECT_EQ(context().debug_messages().take().size(), DebugMessages::capacity);
}

TEST_P(ContextTest, MovesToAnotherThread) {
    Context::release_current();
    std::thread([&] {
        context().make_current();
        Texture texture({2, 2, Format::r8}, "made elsewhere");
        texture.clear(std::array{1.0f, 0.0f, 0.0f, 0.0f});
        EXPECT_EQ(texture.read_bytes()[3], 255);
        texture = Texture();
        Context::release_current();
    }).join();
    context().make_current();
}

TEST_P(ContextTest, LabelsAreCutToWhatDriversTake) {
    const Texture texture({1, 1, Format::r8}, std::string(5000, 'x'));
    GLsizei length = 0;
    std::string label(5001, '\0');
    gl().GetObjectLabel(GL_TEXTURE, texture.name(), static_cast<GLsizei>(label.size()), &length, label.data());
    EXPECT_GE(length, 200);
    EXPECT_LT(length, 5000);
}

HACHURE_INSTANTIATE_GL_TESTS(ContextTest);

/// A context of its own, or null with a skip message where the back end has none.
std::unique_ptr<Context> try_context(Backend backend, bool debug = false) {
    try {
        return make_context({.backend = backend, .debug = debug, .visible = false});
    } catch (const Error&) {
        return nullptr;
    }
}

void expect_draws(Context& context, float value) {
    context.make_current();
    Texture texture({3, 2, Format::r32f}, "value");
    texture.clear(std::array{value, 0.0f, 0.0f, 0.0f});
    EXPECT_THAT(texture.read_floats(), ::testing::Each(value));
    EXPECT_NO_THROW(check_debug_messages());
}

class ContextPairTest : public ::testing::TestWithParam<std::pair<Backend, Backend>> {};

TEST_P(ContextPairTest, LiveInOneProcess) {
    auto first = try_context(GetParam().first);
    auto second = try_context(GetParam().second);
    if (!first || !second) GTEST_SKIP() << "this machine lacks one of the two back ends";
    for (int round = 0; round < 3; ++round) {
        expect_draws(*first, 1.5f);
        expect_draws(*second, -2.5f);
    }
    // The first goes while the second is current, which stays so.
    first.reset();
    EXPECT_EQ(Context::current(), second.get());
    expect_draws(*second, 0.25f);
    first = try_context(GetParam().first, true);
    ASSERT_NE(first, nullptr);
    expect_draws(*first, 8.0f);
    second.reset();
    expect_draws(*first, 9.0f);
    first.reset();
    EXPECT_EQ(Context::current(), nullptr);
}

std::string pair_name(const ::testing::TestParamInfo<std::pair<Backend, Backend>>& test) {
    return std::string(to_string(test.param.first)) + "_then_" + std::string(to_string(test.param.second));
}

constexpr std::array backend_pairs = {
    std::pair(Backend::egl, Backend::osmesa), std::pair(Backend::osmesa, Backend::egl),
    std::pair(Backend::egl, Backend::egl),    std::pair(Backend::osmesa, Backend::osmesa),
    std::pair(Backend::glfw, Backend::egl),   std::pair(Backend::osmesa, Backend::glfw),
    std::pair(Backend::glfw, Backend::glfw),
};

INSTANTIATE_TEST_SUITE_P(Pairs, ContextPairTest, ::testing::ValuesIn(backend_pairs), pair_name);

TEST(MakeContext, ChoosesABackendByItself) {
    const auto context = try_context(Backend::automatic);
    if (!context) GTEST_SKIP() << "this machine has neither EGL nor OSMesa";
    EXPECT_NE(context->backend(), Backend::automatic);
    EXPECT_EQ(Context::current(), context.get());
}

TEST(MakeContext, NamesTheBackendThatFails) {
    if (getenv("DISPLAY") != nullptr || getenv("WAYLAND_DISPLAY") != nullptr) GTEST_SKIP() << "there is a display";
    const auto before = try_context(Backend::automatic);
    try {
        (void)make_context({.backend = Backend::glfw});
        FAIL() << "a window was opened without a display";
    } catch (const Error& error) {
        EXPECT_THAT(error.what(), ::testing::StartsWith("glfw: "));
        EXPECT_THAT(error.what(), ::testing::HasSubstr("DISPLAY"));
    }
    EXPECT_EQ(Context::current(), before.get());
}

TEST(BackendNames, GoBothWays) {
    for (const Backend backend : {Backend::automatic, Backend::egl, Backend::osmesa, Backend::glfw}) {
        EXPECT_EQ(backend_from_string(to_string(backend)), backend);
    }
    EXPECT_EQ(to_string(Backend::automatic), "auto");
    EXPECT_FALSE(backend_from_string("vulkan").has_value());
}

} // namespace
} // namespace hachure::gpu
