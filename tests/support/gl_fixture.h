#pragma once

#include <hachure/runtime/error.h>
#include <hachure/runtime/gpu/context.h>
#include <hachure/runtime/gpu/debug_messages.h>

#include <gtest/gtest.h>

#include <cstdlib>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace hachure::test {

/// One debug context per back end and process, made at first use and gone before the process ends.
class GlContexts : public ::testing::Environment {
public:
    /// The context, current; or null with the reason why there is none. A GLFW context has a hidden window of 64x64.
    /// Automatic is the first of EGL and OSMesa that has one, which is no other context than that back end's.
    static gpu::Context* use(gpu::Backend backend, std::string& reason) {
        if (backend == gpu::Backend::automatic) {
            gpu::Context* const egl = use(gpu::Backend::egl, reason);
            return egl != nullptr ? egl : use(gpu::Backend::osmesa, reason);
        }
        Slot& slot = slots()[backend];
        if (!slot.tried) {
            slot.tried = true;
            try {
                slot.context = gpu::make_context(
                    {.backend = backend, .debug = true, .width = 64, .height = 64, .visible = false, .vsync = false});
            } catch (const Error& error) {
                slot.reason = error.what();
            }
        }
        reason = slot.reason;
        if (slot.context) slot.context->make_current();
        return slot.context.get();
    }

    void TearDown() override { slots().clear(); }

private:
    struct Slot {
        bool tried = false;
        std::unique_ptr<gpu::Context> context;
        std::string reason;
    };

    static std::map<gpu::Backend, Slot>& slots() {
        static std::map<gpu::Backend, Slot> instance;
        return instance;
    }
};

inline ::testing::Environment* const gl_contexts = ::testing::AddGlobalTestEnvironment(new GlContexts);

/// A test that runs on a back end, or once on each, with that context current. It is skipped where the back end has no
/// context, and fails when the driver reports an error that the test did not take:
///
///     using MyTest = hachure::test::GlTest;
///     TEST_P(MyTest, DoesSomething) { ... }
///     HACHURE_INSTANTIATE_GL_TESTS(MyTest);
class GlTest : public ::testing::TestWithParam<gpu::Backend> {
protected:
    void SetUp() override {
        std::string reason;
        context_ = GlContexts::use(GetParam(), reason);
        if (context_ == nullptr) GTEST_SKIP() << "no context: " << reason;
    }

    void TearDown() override {
        if (context_ == nullptr) return;
        // A test may have made another context current, or none.
        context_->make_current();
        try {
            gpu::check_debug_messages();
        } catch (const Error& error) {
            ADD_FAILURE() << error.what();
        }
    }

    [[nodiscard]] gpu::Context& context() const { return *context_; }

private:
    gpu::Context* context_ = nullptr;
};

inline std::string gl_test_name(const ::testing::TestParamInfo<gpu::Backend>& info) {
    return std::string(gpu::to_string(info.param));
}

/// EGL and OSMesa, and GLFW, which has a context where there is a display.
inline std::vector<gpu::Backend> every_backend() {
    return {gpu::Backend::egl, gpu::Backend::osmesa, gpu::Backend::glfw};
}

/// One that has a context; every one with HACHURE_EVERY_BACKEND in the environment.
inline std::vector<gpu::Backend> one_backend() {
    return std::getenv("HACHURE_EVERY_BACKEND") != nullptr ? every_backend() : std::vector{gpu::Backend::automatic};
}

} // namespace hachure::test

/// Instantiates the tests of a GlTest fixture on EGL and OSMesa, and on GLFW where there is a display: for what depends
/// on the context, and for a fixture or two of each capability, quick ones that draw all it draws.
#define HACHURE_INSTANTIATE_GL_TESTS(fixture)                                                                          \
    INSTANTIATE_TEST_SUITE_P(Gl, fixture, ::testing::ValuesIn(::hachure::test::every_backend()),                       \
                             ::hachure::test::gl_test_name)

/// The same on one back end: for numbers and long sequences of pictures, which come from the same calls on all of them.
/// On a machine whose back ends have different drivers, HACHURE_EVERY_BACKEND=1 compares these, too.
#define HACHURE_INSTANTIATE_GL_TESTS_ONCE(fixture)                                                                     \
    INSTANTIATE_TEST_SUITE_P(Gl, fixture, ::testing::ValuesIn(::hachure::test::one_backend()),                         \
                             ::hachure::test::gl_test_name)
