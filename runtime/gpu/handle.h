#pragma once

#include <hachure/runtime/assert.h>
#include <hachure/runtime/gpu/gl.h>

#include <utility>

namespace hachure::gpu::detail {

/// The name of one GL object, owned. `Delete` deletes it in the current context. Move-only; a moved-from handle is 0.
template <void (*Delete)(GLuint)> class Handle {
public:
    Handle() = default;
    /// Takes over an object of the current context.
    explicit Handle(GLuint name) : name_(name), owner_(&gl()) {}
    Handle(Handle&& other) noexcept
        : name_(std::exchange(other.name_, 0)), owner_(std::exchange(other.owner_, nullptr)) {}
    Handle& operator=(Handle&& other) noexcept {
        if (this != &other) {
            reset();
            name_ = std::exchange(other.name_, 0);
            owner_ = std::exchange(other.owner_, nullptr);
        }
        return *this;
    }
    ~Handle() { reset(); }

    [[nodiscard]] GLuint get() const { return name_; }

private:
    void reset() {
        if (name_ == 0) return;
        HACHURE_ASSERT(has_gl() && owner_ == &gl(), "a GL object is destroyed outside the context that made it");
        Delete(name_);
        name_ = 0;
    }

    GLuint name_ = 0;
    const GlFunctions* owner_ = nullptr;
};

} // namespace hachure::gpu::detail
