#pragma once

#include <hachure/runtime/gpu/gl_functions.h>

#include <GL/glcorearb.h>

#include <string_view>

namespace hachure::gpu {

/// The OpenGL entries of one context, without their "gl": `gl().DrawArrays(GL_TRIANGLES, 0, 3)`. None is null.
struct GlFunctions {
#define HACHURE_GL_MEMBER(name, type) PFNGL##type##PROC name = nullptr;
    HACHURE_GL_FUNCTIONS(HACHURE_GL_MEMBER)
#undef HACHURE_GL_MEMBER
};

/// The table of the context that is current on this thread (Context::make_current). Asserts that there is one.
[[nodiscard]] const GlFunctions& gl();

/// Whether a context is current on this thread.
[[nodiscard]] bool has_gl();

namespace detail {

using GlProcedure = void (*)();
using GetProcAddress = GlProcedure (*)(const char* name);

/// Fills a table through a back end's own lookup. Throws Error(subject, ...) naming the first entry that is missing.
[[nodiscard]] GlFunctions load_gl_functions(GetProcAddress get_proc_address, std::string_view subject);

/// What gl() returns on this thread from now on; null: nothing is current.
void set_current_gl(const GlFunctions* functions);

} // namespace detail
} // namespace hachure::gpu
