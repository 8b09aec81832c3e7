#include <hachure/runtime/assert.h>
#include <hachure/runtime/error.h>
#include <hachure/runtime/gpu/debug_messages.h>
#include <hachure/runtime/gpu/framebuffer.h>

#include <fmt/format.h>

#include <vector>

namespace hachure::gpu {
namespace {

std::string_view incompleteness(GLenum status) {
    switch (status) {
    case GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT:
        return "a texture cannot be drawn into";
    case GL_FRAMEBUFFER_INCOMPLETE_MISSING_ATTACHMENT:
        return "nothing is attached";
    case GL_FRAMEBUFFER_INCOMPLETE_DRAW_BUFFER:
        return "an output has no texture";
    case GL_FRAMEBUFFER_UNSUPPORTED:
        return "the driver does not support this combination of formats";
    case GL_FRAMEBUFFER_INCOMPLETE_MULTISAMPLE:
        return "the textures differ in their number of samples";
    case GL_FRAMEBUFFER_INCOMPLETE_LAYER_TARGETS:
        return "layered and plain textures are mixed";
    default:
        return "the driver refuses it";
    }
}

std::vector<Attachment> as_attachments(std::initializer_list<const Texture*> textures) {
    std::vector<Attachment> attachments;
    for (const Texture* texture : textures) attachments.push_back({texture});
    return attachments;
}

constexpr GLenum color_point(std::size_t index) { return GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(index); }

/// Lets a clear write every channel, whatever the pass lets its shaders write.
class OpenColorMask {
public:
    OpenColorMask() {
        gl().GetBooleanv(GL_COLOR_WRITEMASK, mask_.data());
        gl().ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    }
    ~OpenColorMask() { gl().ColorMask(mask_[0], mask_[1], mask_[2], mask_[3]); }
    OpenColorMask(const OpenColorMask&) = delete;
    OpenColorMask& operator=(const OpenColorMask&) = delete;

private:
    std::array<GLboolean, 4> mask_{};
};

GLenum gl_filter(Filter filter) { return filter == Filter::linear ? GL_LINEAR : GL_NEAREST; }

} // namespace

Framebuffer::Framebuffer(std::span<const Attachment> colors, Attachment depth, std::string_view label) {
    GLuint name = 0;
    gl().CreateFramebuffers(1, &name);
    handle_ = detail::Handle<&Framebuffer::destroy>(name);
    label_object(GL_FRAMEBUFFER, name, label);
    for (std::size_t i = 0; i < colors.size(); ++i) {
        attach(color_point(i), colors[i]);
        outputs_.push_back(colors[i].texture != nullptr ? color_point(i) : GL_NONE);
    }
    attach(GL_DEPTH_ATTACHMENT, depth);
    gl().NamedFramebufferDrawBuffers(name, static_cast<GLsizei>(outputs_.size()), outputs_.data());
    if (outputs_.empty() || outputs_.front() == GL_NONE) gl().NamedFramebufferReadBuffer(name, GL_NONE);
    const GLenum status = gl().CheckNamedFramebufferStatus(name, GL_DRAW_FRAMEBUFFER);
    if (status != GL_FRAMEBUFFER_COMPLETE) {
        throw Error(label, fmt::format("the framebuffer is incomplete: {}", incompleteness(status)));
    }
}

Framebuffer::Framebuffer(std::initializer_list<const Texture*> colors, const Texture* depth, std::string_view label)
    : Framebuffer(as_attachments(colors), {depth}, label) {}

void Framebuffer::attach(GLenum point, const Attachment& attachment) {
    if (attachment.texture == nullptr) return;
    const Texture& texture = *attachment.texture;
    HACHURE_ASSERT(attachment.level >= 0 && attachment.level < texture.desc().levels, "the texture has no such level");
    HACHURE_ASSERT(is_depth(texture.desc().format) == (point == GL_DEPTH_ATTACHMENT),
                   "depth is attached as colour, or colour as depth");
    const int width = texture.width(attachment.level), height = texture.height(attachment.level);
    HACHURE_ASSERT(width_ == 0 || (width_ == width && height_ == height), "a framebuffer's textures have one size");
    width_ = width;
    height_ = height;
    gl().NamedFramebufferTexture(name(), point, texture.name(), attachment.level);
}

void Framebuffer::destroy(GLuint name) { gl().DeleteFramebuffers(1, &name); }

void Framebuffer::bind() const { gl().BindFramebuffer(GL_FRAMEBUFFER, name()); }

void Framebuffer::bind_window() { gl().BindFramebuffer(GL_FRAMEBUFFER, 0); }

void Framebuffer::clear_color(int index, const std::array<float, 4>& value) const {
    const OpenColorMask open;
    gl().ClearNamedFramebufferfv(name(), GL_COLOR, index, value.data());
}

void Framebuffer::clear_color(int index, const std::array<std::uint32_t, 4>& value) const {
    const OpenColorMask open;
    gl().ClearNamedFramebufferuiv(name(), GL_COLOR, index, value.data());
}

void Framebuffer::clear_depth(float value) const {
    GLboolean mask = GL_TRUE;
    gl().GetBooleanv(GL_DEPTH_WRITEMASK, &mask);
    gl().DepthMask(GL_TRUE);
    gl().ClearNamedFramebufferfv(name(), GL_DEPTH, 0, &value);
    gl().DepthMask(mask);
}

void Framebuffer::blit_color(const Framebuffer& target, int from, int to, Filter filter) const {
    gl().NamedFramebufferReadBuffer(name(), color_point(static_cast<std::size_t>(from)));
    // A blit writes every output of its target, so the target is narrowed to one meanwhile.
    gl().NamedFramebufferDrawBuffer(target.name(), color_point(static_cast<std::size_t>(to)));
    gl().BlitNamedFramebuffer(name(), target.name(), 0, 0, width_, height_, 0, 0, target.width_, target.height_,
                              GL_COLOR_BUFFER_BIT, gl_filter(filter));
    gl().NamedFramebufferDrawBuffers(target.name(), static_cast<GLsizei>(target.outputs_.size()),
                                     target.outputs_.data());
}

void Framebuffer::blit_depth(const Framebuffer& target) const {
    HACHURE_ASSERT(width_ == target.width_ && height_ == target.height_, "depth is copied between equal sizes");
    gl().BlitNamedFramebuffer(name(), target.name(), 0, 0, width_, height_, 0, 0, width_, height_, GL_DEPTH_BUFFER_BIT,
                              GL_NEAREST);
}

void Framebuffer::blit_to_window(const Rect& to, Filter filter) const {
    gl().NamedFramebufferReadBuffer(name(), GL_COLOR_ATTACHMENT0);
    gl().BlitNamedFramebuffer(name(), 0, 0, 0, width_, height_, to.x, to.y, to.x + to.width, to.y + to.height,
                              GL_COLOR_BUFFER_BIT, gl_filter(filter));
}

} // namespace hachure::gpu
