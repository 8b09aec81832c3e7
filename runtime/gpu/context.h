#pragma once

#include <hachure/runtime/gpu/gl.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

struct GLFWwindow;

namespace hachure::gpu {

class DebugMessages;

/// Where a context comes from.
enum class Backend : std::uint8_t {
    automatic, ///< EGL, or OSMesa where EGL has no display
    egl,       ///< off screen; a hardware device where there is one, else Mesa's software rasteriser
    osmesa,    ///< off screen, Mesa's software rasteriser in this process
    glfw,      ///< a window
};

/// The name on the command line: "auto", "egl", "osmesa", "glfw".
[[nodiscard]] std::string_view to_string(Backend backend);

/// The back end of a command line name, or nothing.
[[nodiscard]] std::optional<Backend> backend_from_string(std::string_view name);

/// What to make a context with. The window's fields matter to `Backend::glfw` alone.
struct ContextOptions {
    Backend backend = Backend::automatic;
    bool debug = false; ///< asks the driver for a debug context: more messages, slower calls
    int width = 1280;   ///< of the window, screen coordinates, >= 1
    int height = 720;   ///< of the window, screen coordinates, >= 1
    std::string title = "Hachure";
    bool visible = true; ///< whether the window is shown at once
    bool vsync = true;   ///< whether swap_buffers waits for the display
};

/// What the driver says of itself.
struct ContextDescription {
    std::string vendor;
    std::string renderer;
    std::string version;
    bool software = false; ///< the renderer is a software rasteriser

    /// "renderer (version)", one line.
    [[nodiscard]] std::string summary() const;
};

/// What the driver allows; at least what OpenGL 4.5 asks for.
struct ContextLimits {
    int max_texture_size = 0;      ///< texels along a side
    int max_viewport_width = 0;    ///< pixels
    int max_viewport_height = 0;   ///< pixels
    int max_color_attachments = 0; ///< of one framebuffer
    int max_draw_buffers = 0;      ///< outputs of a fragment shader
    int max_texture_units = 0;     ///< over all stages of a program
    int max_samples = 0;           ///< of a multisampled colour texture
    int max_uniform_block_bytes = 0;
    std::int64_t max_storage_block_bytes = 0;
    float max_anisotropy = 1.0f; ///< 1: anisotropic filtering is missing
};

/// An OpenGL 4.5 core context. Contexts of several back ends can live in one process, in any order; each thread has at
/// most one current. GPU objects belong to the context that was current when they were made, and are destroyed while it
/// is current and before it goes. Drawing goes to framebuffer objects; only a GLFW context has a framebuffer 0.
class Context {
public:
    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;
    virtual ~Context();

    /// Makes this context current on this thread, in place of the one that was. Cheap when it is already. Throws Error
    /// when the driver refuses.
    void make_current();

    /// Leaves this thread without a current context.
    static void release_current();

    /// The context current on this thread, or null.
    [[nodiscard]] static Context* current();

    /// Never `automatic`.
    [[nodiscard]] Backend backend() const { return backend_; }
    [[nodiscard]] const ContextDescription& description() const { return description_; }
    [[nodiscard]] const ContextLimits& limits() const { return limits_; }
    [[nodiscard]] bool is_software() const { return description_.software; }
    /// What KHR_debug reported, see debug_messages.h.
    [[nodiscard]] DebugMessages& debug_messages() { return *debug_messages_; }

    /// The window, owned by the context; null on off-screen back ends.
    [[nodiscard]] virtual GLFWwindow* window() const { return nullptr; }
    /// Shows what was drawn to framebuffer 0. Nothing happens on off-screen back ends.
    virtual void swap_buffers() {}
    /// Delivers the window's pending events to its callbacks. Nothing happens on off-screen back ends.
    virtual void poll_events() {}

protected:
    explicit Context(Backend backend);

    /// Makes the fresh native context current and loads its functions; the last step of each back end's set-up. Throws
    /// Error when a function is missing or the version is below 4.5.
    void finish_setup(detail::GetProcAddress get_proc_address, bool debug);
    /// Leaves the thread without a current context if this one is; the first step of each back end's tear-down.
    void release_if_current();

    virtual void native_make_current() = 0;
    virtual void native_release() = 0;

private:
    Backend backend_;
    GlFunctions functions_;
    ContextDescription description_;
    ContextLimits limits_;
    std::unique_ptr<DebugMessages> debug_messages_;
};

/// Makes a context and makes it current on this thread. Throws Error that names the back end and says why not; what was
/// current stays current then.
[[nodiscard]] std::unique_ptr<Context> make_context(const ContextOptions& options = {});

namespace detail {
[[nodiscard]] std::unique_ptr<Context> make_egl_context(const ContextOptions& options);
[[nodiscard]] std::unique_ptr<Context> make_osmesa_context(const ContextOptions& options);
[[nodiscard]] std::unique_ptr<Context> make_glfw_context(const ContextOptions& options);
} // namespace detail

} // namespace hachure::gpu
