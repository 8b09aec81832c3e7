#include <hachure/runtime/gpu/frame_graph_declaration.h>
#include <hachure/runtime/gpu/frame_graph_pass.h>

namespace hachure::gpu {

TextureHandle PassBuilder::create(std::string_view name, const TextureDesc& desc) {
    return frame_->create(pass_, name, desc);
}

TextureHandle PassBuilder::read(TextureHandle handle) { return frame_->read(pass_, handle); }

TextureHandle PassBuilder::write(TextureHandle handle) { return frame_->write(pass_, handle); }

void PassBuilder::side_effect() { frame_->passes[pass_].side_effect = true; }

void PassBuilder::covers(std::uint64_t pixels) { frame_->passes[pass_].pixels = pixels; }

KeyHash& PassBuilder::keys() {
    detail::PassNode& pass = frame_->passes[pass_];
    pass.has_keys = true;
    return pass.keys;
}

std::uint32_t PassContext::texture(TextureHandle handle) const { return *frame_->declared_texture(pass_, handle).id; }

const TextureDesc& PassContext::desc(TextureHandle handle) const {
    return frame_->declared_texture(pass_, handle).desc;
}

} // namespace hachure::gpu
