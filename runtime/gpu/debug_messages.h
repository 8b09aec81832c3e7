#pragma once

#include <hachure/runtime/gpu/gl.h>

#include <cstddef>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

namespace hachure::gpu {

/// One message of the driver (KHR_debug).
struct DebugMessage {
    GLenum source = 0;
    GLenum type = 0;
    GLenum severity = 0;
    GLuint id = 0;
    std::string text; ///< one line
};

/// The messages of one context since they were last taken. Notifications are dropped, and so are the shader compiler's
/// messages: Program reports those with file and line.
class DebugMessages {
public:
    /// How many are kept until take(); later ones are dropped.
    static constexpr std::size_t capacity = 64;

    /// Routes the current context's messages here until it is gone (glDebugMessageCallback). `synchronous`: a message
    /// arrives before the call at fault returns, so that a debugger shows the call.
    void attach(bool synchronous);

    /// Whether a message says that a call was wrong, rather than slow or worth knowing: an error or undefined behaviour
    /// of medium or high severity.
    [[nodiscard]] static bool is_error(const DebugMessage& message);

    /// The messages so far, oldest first; none are left.
    [[nodiscard]] std::vector<DebugMessage> take();

private:
    static void APIENTRY receive(GLenum source, GLenum type, GLuint id, GLenum severity, GLsizei length,
                                 const GLchar* text, const void* user);

    std::mutex mutex_; // a driver may report from a thread of its own
    std::vector<DebugMessage> messages_;
};

/// Throws Error with the first error among the current context's messages (or of glGetError, for drivers that report
/// nothing without a debug context), and forgets them all. Called once a frame, and after every test.
void check_debug_messages();

/// Names a GL object in the driver's messages and in frame debuggers (glObjectLabel); names that are too long are cut.
void label_object(GLenum kind, GLuint object, std::string_view label);

/// Groups the calls of its lifetime under a name in frame debuggers (glPushDebugGroup).
class DebugGroup {
public:
    explicit DebugGroup(std::string_view name);
    ~DebugGroup();
    DebugGroup(const DebugGroup&) = delete;
    DebugGroup& operator=(const DebugGroup&) = delete;
};

} // namespace hachure::gpu
