#include <hachure/runtime/assert.h>
#include <hachure/runtime/error.h>
#include <hachure/runtime/gpu/gl.h>

#include <fmt/format.h>

namespace hachure::gpu {
namespace {
thread_local const GlFunctions* current_functions = nullptr;
} // namespace

const GlFunctions& gl() {
    HACHURE_ASSERT(current_functions != nullptr, "no OpenGL context is current on this thread");
    return *current_functions;
}

bool has_gl() { return current_functions != nullptr; }

namespace detail {

GlFunctions load_gl_functions(GetProcAddress get_proc_address, std::string_view subject) {
    GlFunctions functions;
    const auto load = [&](auto& entry, const char* name) {
        entry = reinterpret_cast<std::remove_reference_t<decltype(entry)>>(get_proc_address(name));
        if (entry == nullptr) throw Error(subject, fmt::format("the driver has no {}", name));
    };
#define HACHURE_LOAD_GL(name, type) load(functions.name, "gl" #name);
    HACHURE_GL_FUNCTIONS(HACHURE_LOAD_GL)
#undef HACHURE_LOAD_GL
    return functions;
}

void set_current_gl(const GlFunctions* functions) { current_functions = functions; }

} // namespace detail
} // namespace hachure::gpu
