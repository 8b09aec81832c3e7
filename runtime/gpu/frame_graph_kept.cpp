#include <hachure/runtime/assert.h>
#include <hachure/runtime/gpu/frame_graph_kept.h>

#include <iterator>

namespace hachure::gpu::detail {

bool KeptResults::fits(const Texture& texture, const TextureNode& node) {
    return texture.desc == node.desc && texture.owned == node.owned() &&
           (texture.owned || texture.id == node.import->id);
}

bool KeptResults::holds(const TextureNode& node) const {
    const auto found = textures_.find(node.key);
    return found != textures_.end() && fits(found->second, node) && found->second.signature &&
           found->second.signature == node.signature;
}

std::optional<std::uint32_t> KeptResults::reuse(const TextureNode& node) {
    const auto found = textures_.find(node.key);
    if (found == textures_.end()) return std::nullopt;
    Texture& texture = found->second;
    if (!fits(texture, node)) {
        drop(node);
        return std::nullopt;
    }
    texture.idle = 0;
    if (node.runs) texture.signature.reset();
    return texture.id;
}

void KeptResults::keep(const TextureNode& node, std::uint32_t id) {
    const bool is_new = textures_.try_emplace(node.key, Texture{id, node.desc, node.owned(), std::nullopt, 0}).second;
    HACHURE_ASSERT(is_new, "two textures are kept under one name");
}

void KeptResults::finish(const TextureNode& node) { textures_.at(node.key).signature = node.signature; }

void KeptResults::drop(const TextureNode& node) {
    const auto found = textures_.find(node.key);
    if (found == textures_.end()) return;
    give_back(found->second);
    textures_.erase(found);
}

void KeptResults::give_back(const Texture& texture) {
    if (texture.owned) pool_->release(texture.id);
}

bool KeptResults::effect_done(const PassNode& pass) const {
    const auto found = effects_.find(pass.key);
    return found != effects_.end() && found->second.signature && found->second.signature == pass.signature;
}

void KeptResults::reuse_effect(const PassNode& pass) {
    Effect& effect = effects_[pass.key];
    effect.idle = 0;
    if (pass.state == PassState::run) effect.signature.reset();
}

void KeptResults::finish_effect(const PassNode& pass) { effects_.at(pass.key).signature = pass.signature; }

void KeptResults::end_frame(std::uint32_t idle_frames) {
    for (auto texture = textures_.begin(); texture != textures_.end();) {
        if (texture->second.idle++ < idle_frames) {
            ++texture;
        } else {
            give_back(texture->second);
            texture = textures_.erase(texture);
        }
    }
    for (auto effect = effects_.begin(); effect != effects_.end();) {
        effect = effect->second.idle++ < idle_frames ? std::next(effect) : effects_.erase(effect);
    }
}

void KeptResults::forget() {
    for (auto& [key, texture] : textures_) texture.signature.reset();
    effects_.clear();
}

std::size_t KeptResults::bytes() const {
    std::size_t total = 0;
    for (const auto& [key, texture] : textures_) total += texture.owned ? texture.desc.bytes() : 0;
    return total;
}

} // namespace hachure::gpu::detail
