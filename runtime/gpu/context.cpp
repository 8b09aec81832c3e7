#include <hachure/runtime/assert.h>
#include <hachure/runtime/error.h>
#include <hachure/runtime/gpu/context.h>
#include <hachure/runtime/gpu/debug_messages.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

namespace hachure::gpu {
namespace {

thread_local Context* current_context = nullptr;

constexpr std::array<std::pair<Backend, std::string_view>, 4> backend_names = {{
    {Backend::automatic, "auto"},
    {Backend::egl, "egl"},
    {Backend::osmesa, "osmesa"},
    {Backend::glfw, "glfw"},
}};

std::string get_string(GLenum what) {
    const auto* text = reinterpret_cast<const char*>(gl().GetString(what));
    return text != nullptr ? text : "";
}

int get_int(GLenum what) {
    GLint value = 0;
    gl().GetIntegerv(what, &value);
    return value;
}

ContextDescription describe() {
    ContextDescription description{get_string(GL_VENDOR), get_string(GL_RENDERER), get_string(GL_VERSION)};
    for (const char* rasteriser : {"llvmpipe", "softpipe", "swrast", "SWR", "Software Rasterizer"}) {
        description.software |= description.renderer.find(rasteriser) != std::string::npos;
    }
    return description;
}

bool has_extension(std::string_view wanted) {
    const int count = get_int(GL_NUM_EXTENSIONS);
    for (GLuint i = 0; i < static_cast<GLuint>(count); ++i) {
        const auto* name = reinterpret_cast<const char*>(gl().GetStringi(GL_EXTENSIONS, i));
        if (name != nullptr && wanted == name) return true;
    }
    return false;
}

ContextLimits query_limits() {
    ContextLimits limits;
    limits.max_texture_size = get_int(GL_MAX_TEXTURE_SIZE);
    std::array<GLint, 2> viewport{};
    gl().GetIntegerv(GL_MAX_VIEWPORT_DIMS, viewport.data());
    limits.max_viewport_width = viewport[0];
    limits.max_viewport_height = viewport[1];
    limits.max_color_attachments = get_int(GL_MAX_COLOR_ATTACHMENTS);
    limits.max_draw_buffers = get_int(GL_MAX_DRAW_BUFFERS);
    limits.max_texture_units = get_int(GL_MAX_COMBINED_TEXTURE_IMAGE_UNITS);
    limits.max_samples = std::min(get_int(GL_MAX_SAMPLES), get_int(GL_MAX_COLOR_TEXTURE_SAMPLES));
    limits.max_uniform_block_bytes = get_int(GL_MAX_UNIFORM_BLOCK_SIZE);
    GLint64 storage = 0;
    gl().GetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &storage);
    limits.max_storage_block_bytes = storage;
    // Core in 4.6 only, with the extension's value; every driver at hand has the extension.
    constexpr GLenum max_anisotropy = 0x84FF;
    if (has_extension("GL_ARB_texture_filter_anisotropic") || has_extension("GL_EXT_texture_filter_anisotropic")) {
        gl().GetFloatv(max_anisotropy, &limits.max_anisotropy);
    }
    return limits;
}

std::unique_ptr<Context> make_native_context(const ContextOptions& options) {
    switch (options.backend) {
    case Backend::egl:
        return detail::make_egl_context(options);
    case Backend::osmesa:
        return detail::make_osmesa_context(options);
    case Backend::glfw:
        return detail::make_glfw_context(options);
    case Backend::automatic:
        break;
    }
    try {
        return detail::make_egl_context(options);
    } catch (const Error& egl) {
        try {
            return detail::make_osmesa_context(options);
        } catch (const Error& osmesa) {
            throw Error(fmt::format("no OpenGL context could be made: {}; {}", egl.what(), osmesa.what()));
        }
    }
}

} // namespace

std::string_view to_string(Backend backend) {
    return std::find_if(backend_names.begin(), backend_names.end(),
                        [&](const auto& row) { return row.first == backend; })
        ->second;
}

std::optional<Backend> backend_from_string(std::string_view name) {
    for (const auto& [backend, text] : backend_names) {
        if (text == name) return backend;
    }
    return std::nullopt;
}

std::string ContextDescription::summary() const { return fmt::format("{} ({})", renderer, version); }

Context::Context(Backend backend) : backend_(backend), debug_messages_(std::make_unique<DebugMessages>()) {}

Context::~Context() { HACHURE_ASSERT(current_context != this, "a back end did not release its context"); }

void Context::make_current() {
    if (current_context == this) return;
    // Mesa's libraries share one "current context" slot: releasing the old one after binding the new would empty it.
    release_current();
    native_make_current();
    current_context = this;
    detail::set_current_gl(&functions_);
}

void Context::release_current() {
    if (current_context == nullptr) return;
    current_context->native_release();
    current_context = nullptr;
    detail::set_current_gl(nullptr);
}

void Context::release_if_current() {
    if (current_context == this) release_current();
}

Context* Context::current() { return current_context; }

void Context::finish_setup(detail::GetProcAddress get_proc_address, bool debug) {
    make_current();
    functions_ = detail::load_gl_functions(get_proc_address, to_string(backend_));
    const int version = get_int(GL_MAJOR_VERSION) * 10 + get_int(GL_MINOR_VERSION);
    description_ = describe();
    if (version < 45) {
        throw Error(to_string(backend_), fmt::format("OpenGL 4.5 is needed, not {}", description_.version));
    }
    limits_ = query_limits();
    // Errors are always reported where the driver can; a debug context makes it say more.
    debug_messages_->attach(debug);
}

std::unique_ptr<Context> make_context(const ContextOptions& options) {
    // GLX refuses to make its context current, on its own way through glfwCreateWindow, while one of EGL's is.
    Context* const before = Context::current();
    Context::release_current();
    try {
        return make_native_context(options);
    } catch (...) {
        if (before != nullptr) before->make_current();
        throw;
    }
}

} // namespace hachure::gpu
