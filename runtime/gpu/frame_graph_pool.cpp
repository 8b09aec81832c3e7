#include <hachure/runtime/assert.h>
#include <hachure/runtime/gpu/frame_graph_pool.h>

#include <algorithm>
#include <vector>

namespace hachure::gpu::detail {

TexturePool::~TexturePool() {
    for (const Slot& slot : slots_) backend_->destroy_texture(slot.id);
}

std::uint32_t TexturePool::acquire(const TextureDesc& desc, std::string_view label) {
    const auto found =
        std::find_if(slots_.begin(), slots_.end(), [&](const Slot& slot) { return !slot.in_use && slot.desc == desc; });
    if (found != slots_.end()) {
        found->in_use = true;
        found->idle = 0;
        return found->id;
    }
    slots_.reserve(slots_.size() + 1); // so that nothing can throw once the texture exists
    const std::uint32_t id = backend_->create_texture(desc, label);
    slots_.push_back({id, desc, true, 0});
    bytes_ += desc.bytes();
    return id;
}

void TexturePool::release(std::uint32_t id) {
    const auto found = std::find_if(slots_.begin(), slots_.end(), [&](const Slot& slot) { return slot.id == id; });
    HACHURE_ASSERT(found != slots_.end() && found->in_use, "a texture is released that was not acquired");
    found->in_use = false;
}

void TexturePool::end_frame(std::uint32_t idle_frames) {
    for (Slot& slot : slots_) {
        if (slot.in_use || slot.idle++ < idle_frames) continue;
        bytes_ -= slot.desc.bytes();
        backend_->destroy_texture(slot.id);
    }
    std::erase_if(slots_, [&](const Slot& slot) { return !slot.in_use && slot.idle > idle_frames; });
}

} // namespace hachure::gpu::detail
