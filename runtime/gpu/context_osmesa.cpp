#include <hachure/runtime/error.h>
#include <hachure/runtime/gpu/context.h>

#include <GL/osmesa.h>

#include <array>
#include <cstddef>

namespace hachure::gpu {
namespace {

class OsMesaContext final : public Context {
public:
    explicit OsMesaContext(const ContextOptions& options) : Context(Backend::osmesa) {
        // Without depth, stencil and accumulation: drawing goes to framebuffer objects. 4.6 is refused.
        constexpr std::array attributes = {OSMESA_FORMAT,
                                           OSMESA_RGBA,
                                           OSMESA_DEPTH_BITS,
                                           0,
                                           OSMESA_STENCIL_BITS,
                                           0,
                                           OSMESA_ACCUM_BITS,
                                           0,
                                           OSMESA_PROFILE,
                                           OSMESA_CORE_PROFILE,
                                           OSMESA_CONTEXT_MAJOR_VERSION,
                                           4,
                                           OSMESA_CONTEXT_MINOR_VERSION,
                                           5,
                                           0};
        context_ = OSMesaCreateContextAttribs(attributes.data(), nullptr);
        if (context_ == nullptr) throw Error("osmesa", "no OpenGL 4.5 core context could be created");
        try {
            finish_setup(&OSMesaGetProcAddress, options.debug);
        } catch (...) {
            destroy();
            throw;
        }
    }
    ~OsMesaContext() override { destroy(); }

protected:
    void native_make_current() override {
        if (OSMesaMakeCurrent(context_, buffer_.data(), GL_UNSIGNED_BYTE, 1, 1) == GL_FALSE) {
            throw Error("osmesa", "the context could not be made current");
        }
    }
    void native_release() override { OSMesaMakeCurrent(nullptr, nullptr, GL_UNSIGNED_BYTE, 0, 0); }

private:
    void destroy() {
        release_if_current();
        OSMesaDestroyContext(context_);
    }

    OSMesaContext context_ = nullptr;
    std::array<std::byte, 4> buffer_{}; // OSMesa wants a picture of its own; nothing is drawn to it
};

} // namespace

std::unique_ptr<Context> detail::make_osmesa_context(const ContextOptions& options) {
    return std::make_unique<OsMesaContext>(options);
}

} // namespace hachure::gpu
