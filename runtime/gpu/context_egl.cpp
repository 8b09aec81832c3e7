#include <hachure/runtime/error.h>
#include <hachure/runtime/gpu/context.h>

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <memory>
#include <string_view>

namespace hachure::gpu {
namespace {

/// Whether a list of names parted by blanks holds `wanted`; null is an empty list.
bool lists(const char* names, std::string_view wanted) {
    const std::string_view list = names != nullptr ? names : "";
    for (std::size_t begin = 0; begin < list.size();) {
        const std::size_t end = std::min(list.find(' ', begin), list.size());
        if (list.substr(begin, end - begin) == wanted) return true;
        begin = end + 1;
    }
    return false;
}

template <typename Function> Function entry(const char* name) {
    return reinterpret_cast<Function>(eglGetProcAddress(name));
}

/// Initialises `display` when it can take surfaceless contexts of desktop OpenGL; else EGL_NO_DISPLAY.
EGLDisplay initialise(EGLDisplay display) {
    if (display == EGL_NO_DISPLAY || eglInitialize(display, nullptr, nullptr) == EGL_FALSE) return EGL_NO_DISPLAY;
    const char* extensions = eglQueryString(display, EGL_EXTENSIONS);
    const bool usable = lists(extensions, "EGL_KHR_surfaceless_context") &&
                        lists(extensions, "EGL_KHR_create_context") &&
                        lists(eglQueryString(display, EGL_CLIENT_APIS), "OpenGL");
    if (usable) return display;
    eglTerminate(display);
    return EGL_NO_DISPLAY;
}

/// A display on the first hardware device that works, or EGL_NO_DISPLAY. Mesa lists its software rasteriser as a device
/// too; that one is left to the surfaceless platform.
EGLDisplay open_hardware(const char* client_extensions, PFNEGLGETPLATFORMDISPLAYEXTPROC get_display) {
    if (!lists(client_extensions, "EGL_EXT_platform_device") ||
        !(lists(client_extensions, "EGL_EXT_device_base") || lists(client_extensions, "EGL_EXT_device_enumeration"))) {
        return EGL_NO_DISPLAY;
    }
    const auto query_devices = entry<PFNEGLQUERYDEVICESEXTPROC>("eglQueryDevicesEXT");
    const auto query_string = entry<PFNEGLQUERYDEVICESTRINGEXTPROC>("eglQueryDeviceStringEXT");
    if (query_devices == nullptr || query_string == nullptr) return EGL_NO_DISPLAY;
    std::array<EGLDeviceEXT, 32> devices{};
    EGLint count = 0;
    if (query_devices(static_cast<EGLint>(devices.size()), devices.data(), &count) == EGL_FALSE) return EGL_NO_DISPLAY;
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
        if (lists(query_string(devices[i], EGL_EXTENSIONS), "EGL_MESA_device_software")) continue;
        const EGLDisplay display = initialise(get_display(EGL_PLATFORM_DEVICE_EXT, devices[i], nullptr));
        if (display != EGL_NO_DISPLAY) return display;
    }
    return EGL_NO_DISPLAY;
}

EGLDisplay open_display() {
    const char* extensions = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
    // The core entry of EGL 1.5 may be missing before a display is initialised; the extension's is not.
    const auto get_display = entry<PFNEGLGETPLATFORMDISPLAYEXTPROC>("eglGetPlatformDisplayEXT");
    if (get_display == nullptr) throw Error("egl", "the driver has no eglGetPlatformDisplayEXT");
    EGLDisplay display = open_hardware(extensions, get_display);
    if (display == EGL_NO_DISPLAY && lists(extensions, "EGL_MESA_platform_surfaceless")) {
        display = initialise(get_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr));
    }
    if (display == EGL_NO_DISPLAY) throw Error("egl", "no display could be initialised");
    return display;
}

/// The process's display, found at first use. It is never terminated: EGL gives every caller the same one without
/// counting them, and a driver that is unloaded and loaded again costs time, and leaks in Mesa.
EGLDisplay shared_display() {
    static const EGLDisplay display = open_display();
    return display;
}

/// A config for a context that draws to framebuffer objects: any, or none where the driver allows that.
EGLConfig choose_config(EGLDisplay display) {
    if (lists(eglQueryString(display, EGL_EXTENSIONS), "EGL_KHR_no_config_context")) return EGL_NO_CONFIG_KHR;
    constexpr std::array<EGLint, 5> attributes = {EGL_SURFACE_TYPE, EGL_DONT_CARE, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT,
                                                  EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    if (eglChooseConfig(display, attributes.data(), &config, 1, &count) == EGL_FALSE || count == 0) {
        throw Error("egl", "the display has no configuration for OpenGL");
    }
    return config;
}

class EglContext final : public Context {
public:
    explicit EglContext(const ContextOptions& options) : Context(Backend::egl), display_(shared_display()) {
        if (eglBindAPI(EGL_OPENGL_API) == EGL_FALSE) throw Error("egl", "the driver has no desktop OpenGL");
        const std::array<EGLint, 9> attributes = {EGL_CONTEXT_MAJOR_VERSION,
                                                  4,
                                                  EGL_CONTEXT_MINOR_VERSION,
                                                  5,
                                                  EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                                  EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                                  options.debug ? EGL_CONTEXT_FLAGS_KHR : EGL_NONE,
                                                  EGL_CONTEXT_OPENGL_DEBUG_BIT_KHR,
                                                  EGL_NONE};
        context_ = eglCreateContext(display_, choose_config(display_), EGL_NO_CONTEXT, attributes.data());
        if (context_ == EGL_NO_CONTEXT) {
            throw Error("egl",
                        fmt::format("no OpenGL 4.5 core context could be created (EGL error 0x{:04x})", eglGetError()));
        }
        try {
            finish_setup(&eglGetProcAddress, options.debug);
        } catch (...) {
            destroy();
            throw;
        }
    }
    ~EglContext() override { destroy(); }

protected:
    void native_make_current() override {
        eglBindAPI(EGL_OPENGL_API);
        if (eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_) == EGL_FALSE) {
            throw Error("egl",
                        fmt::format("the context could not be made current (EGL error 0x{:04x})", eglGetError()));
        }
    }
    void native_release() override {
        eglBindAPI(EGL_OPENGL_API);
        eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    }

private:
    void destroy() {
        release_if_current();
        eglDestroyContext(display_, context_);
    }

    EGLDisplay display_;
    EGLContext context_ = EGL_NO_CONTEXT;
};

} // namespace

std::unique_ptr<Context> detail::make_egl_context(const ContextOptions& options) {
    return std::make_unique<EglContext>(options);
}

} // namespace hachure::gpu
