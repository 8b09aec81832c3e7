#include <hachure/runtime/assert.h>
#include <hachure/runtime/error.h>
#include <hachure/runtime/gpu/frame_graph_null.h>

#include <numeric>

namespace hachure::gpu {

std::uint32_t NullBackend::create_texture(const TextureDesc& desc, std::string_view label) {
    if (creations_left_ == 0) throw Error("cannot create texture '" + std::string(label) + "'");
    --creations_left_;
    const auto id = static_cast<std::uint32_t>(++created_);
    textures_[id] = desc;
    contents_[id] = 0xbad0000000000000u + id; // garbage, and never the same twice
    return id;
}

void NullBackend::destroy_texture(std::uint32_t id) {
    HACHURE_ASSERT(textures_.erase(id) == 1, "destroys a texture that does not exist");
    contents_.erase(id);
    ++destroyed_;
}

std::uint64_t NullBackend::begin_pass(std::string_view name) {
    HACHURE_ASSERT(!in_pass_, "a pass begins inside another");
    in_pass_ = true;
    passes_.emplace_back(name);
    if (!pass_ms_) return 0;
    timers_[++last_ticket_] = {*pass_ms_, false};
    return last_ticket_;
}

void NullBackend::end_pass() {
    HACHURE_ASSERT(in_pass_, "a pass ends that did not begin");
    in_pass_ = false;
    if (pass_ms_) timers_.at(last_ticket_).ready = !delay_;
}

std::optional<double> NullBackend::gpu_ms(std::uint64_t ticket) {
    const auto timer = timers_.find(ticket);
    HACHURE_ASSERT(timer != timers_.end(), "asks for the time of a pass that was not timed or has been answered");
    if (!timer->second.ready) return std::nullopt;
    const double milliseconds = timer->second.milliseconds;
    timers_.erase(timer);
    return milliseconds;
}

void NullBackend::finish() {
    for (auto& [ticket, timer] : timers_) timer.ready = true;
}

const TextureDesc* NullBackend::desc(std::uint32_t id) const {
    const auto texture = textures_.find(id);
    return texture == textures_.end() ? nullptr : &texture->second;
}

std::size_t NullBackend::alive_bytes() const {
    return std::accumulate(textures_.begin(), textures_.end(), std::size_t{0},
                           [](std::size_t sum, const auto& texture) { return sum + texture.second.bytes(); });
}

} // namespace hachure::gpu
