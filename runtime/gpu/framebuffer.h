#pragma once

#include <hachure/runtime/gpu/handle.h>
#include <hachure/runtime/gpu/rect.h>
#include <hachure/runtime/gpu/texture.h>

#include <array>
#include <cstdint>
#include <initializer_list>
#include <span>
#include <string_view>
#include <vector>

namespace hachure::gpu {

/// One texture that a framebuffer draws into.
struct Attachment {
    const Texture* texture = nullptr; ///< null: this output is dropped
    int level = 0;
};

/// Textures to draw into (glCreateFramebuffers). It does not own them: they must outlive it. Colour attachment i takes
/// output location i of the fragment shader.
class Framebuffer {
public:
    Framebuffer() = default;
    /// At least one attachment, all of one size and one number of samples. Throws Error(label, reason) when the driver
    /// calls the combination incomplete.
    Framebuffer(std::span<const Attachment> colors, Attachment depth, std::string_view label);
    Framebuffer(std::initializer_list<const Texture*> colors, const Texture* depth, std::string_view label);

    /// For drawing and reading (glBindFramebuffer). The viewport is DrawState's.
    void bind() const;
    /// The window's own framebuffer.
    static void bind_window();

    /// Fill one attachment (glClearNamedFramebuffer). The scissor applies, the write masks of DrawState do not.
    void clear_color(int index, const std::array<float, 4>& value) const;
    void clear_color(int index, const std::array<std::uint32_t, 4>& value) const;
    void clear_depth(float value = 1.0f) const;

    /// Copies colour attachment `from` to `target`'s colour attachment `to`, resolving samples; `filter` is for a size
    /// that differs (glBlitNamedFramebuffer). The scissor applies.
    void blit_color(const Framebuffer& target, int from = 0, int to = 0, Filter filter = Filter::nearest) const;
    /// Copies depth, texel by texel; sizes and formats are the same.
    void blit_depth(const Framebuffer& target) const;
    /// Copies colour attachment 0 to a rectangle of the window, values as they are while DrawState::srgb_write is off.
    /// The scissor applies.
    void blit_to_window(const Rect& to, Filter filter = Filter::nearest) const;

    [[nodiscard]] int width() const { return width_; }
    [[nodiscard]] int height() const { return height_; }
    [[nodiscard]] GLuint name() const { return handle_.get(); }
    [[nodiscard]] explicit operator bool() const { return name() != 0; }

private:
    void attach(GLenum point, const Attachment& attachment);
    static void destroy(GLuint name);

    detail::Handle<&Framebuffer::destroy> handle_;
    std::vector<GLenum> outputs_; // the draw buffers
    int width_ = 0;
    int height_ = 0;
};

} // namespace hachure::gpu
