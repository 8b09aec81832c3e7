#include <hachure/runtime/assert.h>
#include <hachure/runtime/error.h>
#include <hachure/runtime/gpu/context.h>

#include <memory>
#include <string>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

namespace hachure::gpu {
namespace {

[[noreturn]] void fail(std::string_view what) {
    const char* reason = nullptr;
    glfwGetError(&reason);
    throw Error("glfw", std::string(what) + (reason != nullptr ? std::string(": ") + reason : std::string()));
}

/// Starts GLFW at the first window. It is never terminated: closing the connection unloads the driver, and loading it
/// again costs time, and leaks in Mesa. The system closes the connection with the process.
void start_glfw() {
    if (glfwInit() == GLFW_FALSE) fail("the window system could not be reached");
}

class GlfwContext final : public Context {
public:
    explicit GlfwContext(const ContextOptions& options) : Context(Backend::glfw) {
        HACHURE_ASSERT(options.width >= 1 && options.height >= 1, "a window has at least one pixel");
        start_glfw();
        set_hints(options);
        window_ = glfwCreateWindow(options.width, options.height, options.title.c_str(), nullptr, nullptr);
        if (window_ == nullptr) fail("no window with OpenGL 4.5 core could be opened");
        try {
            finish_setup(&glfwGetProcAddress, options.debug);
            glfwSwapInterval(options.vsync ? 1 : 0);
        } catch (...) {
            destroy();
            throw;
        }
    }
    ~GlfwContext() override { destroy(); }

    [[nodiscard]] GLFWwindow* window() const override { return window_; }
    void swap_buffers() override { glfwSwapBuffers(window_); }
    void poll_events() override { glfwPollEvents(); }

protected:
    void native_make_current() override {
        glfwMakeContextCurrent(window_);
        if (glfwGetCurrentContext() != window_) fail("the context could not be made current");
    }
    void native_release() override { glfwMakeContextCurrent(nullptr); }

private:
    static void set_hints(const ContextOptions& options) {
        glfwDefaultWindowHints();
        glfwWindowHint(GLFW_CLIENT_API, GLFW_OPENGL_API);
        glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
        glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 5);
        glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
        glfwWindowHint(GLFW_OPENGL_DEBUG_CONTEXT, options.debug ? GLFW_TRUE : GLFW_FALSE);
        glfwWindowHint(GLFW_VISIBLE, options.visible ? GLFW_TRUE : GLFW_FALSE);
        // The window only ever receives finished pictures.
        glfwWindowHint(GLFW_DEPTH_BITS, 0);
        glfwWindowHint(GLFW_STENCIL_BITS, 0);
        glfwWindowHint(GLFW_SAMPLES, 0);
    }

    void destroy() {
        release_if_current();
        glfwDestroyWindow(window_);
    }

    GLFWwindow* window_ = nullptr;
};

} // namespace

std::unique_ptr<Context> detail::make_glfw_context(const ContextOptions& options) {
    return std::make_unique<GlfwContext>(options);
}

} // namespace hachure::gpu
