#include <hachure/runtime/assert.h>
#include <hachure/runtime/error.h>
#include <hachure/runtime/gpu/context.h>
#include <hachure/runtime/gpu/debug_messages.h>

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace hachure::gpu {
namespace {

/// What OpenGL promises at least for labels and messages (GL_MAX_LABEL_LENGTH), with its terminating zero.
constexpr std::size_t max_label_length = 255;

std::string_view error_name(GLenum error) {
    switch (error) {
    case GL_INVALID_ENUM:
        return "GL_INVALID_ENUM";
    case GL_INVALID_VALUE:
        return "GL_INVALID_VALUE";
    case GL_INVALID_OPERATION:
        return "GL_INVALID_OPERATION";
    case GL_INVALID_FRAMEBUFFER_OPERATION:
        return "GL_INVALID_FRAMEBUFFER_OPERATION";
    case GL_OUT_OF_MEMORY:
        return "GL_OUT_OF_MEMORY";
    case GL_CONTEXT_LOST:
        return "GL_CONTEXT_LOST";
    default:
        return "an unknown OpenGL error";
    }
}

/// The oldest error flag, GL_NO_ERROR for none; all flags are reset. A lost context reports its loss forever.
GLenum take_error_flags() {
    const GLenum first = gl().GetError();
    for (GLenum next = first; next != GL_NO_ERROR && next != GL_CONTEXT_LOST;) next = gl().GetError();
    return first;
}

} // namespace

void DebugMessages::attach(bool synchronous) {
    gl().Enable(GL_DEBUG_OUTPUT);
    if (synchronous) gl().Enable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
    gl().DebugMessageCallback(&DebugMessages::receive, this);
    gl().DebugMessageControl(GL_DONT_CARE, GL_DONT_CARE, GL_DEBUG_SEVERITY_NOTIFICATION, 0, nullptr, GL_FALSE);
    gl().DebugMessageControl(GL_DEBUG_SOURCE_SHADER_COMPILER, GL_DONT_CARE, GL_DONT_CARE, 0, nullptr, GL_FALSE);
}

void APIENTRY DebugMessages::receive(GLenum source, GLenum type, GLuint id, GLenum severity, GLsizei length,
                                     const GLchar* text, const void* user) {
    // Groups are ours; some drivers echo them in spite of the filter.
    if (type == GL_DEBUG_TYPE_PUSH_GROUP || type == GL_DEBUG_TYPE_POP_GROUP) return;
    // The callback's user pointer is const in the API; it is the non-const object that attach() gave.
    auto& self = *const_cast<DebugMessages*>(static_cast<const DebugMessages*>(user));
    const std::lock_guard lock(self.mutex_);
    if (self.messages_.size() >= capacity) return;
    const std::string_view view = length >= 0 ? std::string_view(text, static_cast<std::size_t>(length)) : text;
    DebugMessage message{source, type, severity, id, std::string(view)};
    while (!message.text.empty() && (message.text.back() == '\n' || message.text.back() == '\0')) {
        message.text.pop_back();
    }
    std::replace(message.text.begin(), message.text.end(), '\n', ' ');
    self.messages_.push_back(std::move(message));
}

bool DebugMessages::is_error(const DebugMessage& message) {
    const bool wrong = message.type == GL_DEBUG_TYPE_ERROR || message.type == GL_DEBUG_TYPE_UNDEFINED_BEHAVIOR;
    return wrong && (message.severity == GL_DEBUG_SEVERITY_HIGH || message.severity == GL_DEBUG_SEVERITY_MEDIUM);
}

std::vector<DebugMessage> DebugMessages::take() {
    const std::lock_guard lock(mutex_);
    return std::exchange(messages_, {});
}

void check_debug_messages() {
    HACHURE_ASSERT(Context::current() != nullptr, "no OpenGL context is current on this thread");
    const std::vector<DebugMessage> messages = Context::current()->debug_messages().take();
    const GLenum flag = take_error_flags();
    const auto error = std::find_if(messages.begin(), messages.end(), &DebugMessages::is_error);
    if (error != messages.end()) throw Error("OpenGL", error->text);
    if (flag != GL_NO_ERROR) throw Error("OpenGL", error_name(flag));
}

void label_object(GLenum kind, GLuint object, std::string_view label) {
    const std::string_view cut = label.substr(0, max_label_length);
    gl().ObjectLabel(kind, object, static_cast<GLsizei>(cut.size()), cut.data());
}

DebugGroup::DebugGroup(std::string_view name) {
    const std::string_view cut = name.substr(0, max_label_length);
    gl().PushDebugGroup(GL_DEBUG_SOURCE_APPLICATION, 0, static_cast<GLsizei>(cut.size()), cut.data());
}

DebugGroup::~DebugGroup() { gl().PopDebugGroup(); }

} // namespace hachure::gpu
