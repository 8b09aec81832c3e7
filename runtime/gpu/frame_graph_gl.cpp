#include <hachure/runtime/assert.h>
#include <hachure/runtime/gpu/frame_graph_gl.h>

#include <algorithm>
#include <string>

namespace hachure::gpu {

std::uint32_t GlFrameGraphBackend::create_texture(const TextureDesc& desc, std::string_view label) {
    Texture texture(desc, label);
    if (desc.samples == 1) texture.set_sampling(Sampling::nearest());
    const std::uint32_t id = next_id_++;
    textures_.emplace(id, std::move(texture));
    return id;
}

void GlFrameGraphBackend::destroy_texture(std::uint32_t id) {
    std::erase_if(framebuffers_,
                  [id](const auto& entry) { return std::ranges::find(entry.first, id) != entry.first.end(); });
    textures_.erase(id);
}

std::uint64_t GlFrameGraphBackend::begin_pass(std::string_view name) {
    gl().PushDebugGroup(GL_DEBUG_SOURCE_APPLICATION, 0, static_cast<GLsizei>(name.size()), name.data());
    if (idle_queries_.empty()) idle_queries_.emplace_back("pass timer");
    timings_.push_back({next_ticket_++, std::move(idle_queries_.back())});
    idle_queries_.pop_back();
    timings_.back().query.begin();
    return timings_.back().ticket;
}

void GlFrameGraphBackend::end_pass() {
    timings_.back().query.end();
    gl().PopDebugGroup();
}

std::optional<double> GlFrameGraphBackend::gpu_ms(std::uint64_t ticket) {
    const auto timing = std::ranges::find(timings_, ticket, &Timing::ticket);
    HACHURE_ASSERT(timing != timings_.end(), "a ticket that begin_pass gave and that was not answered yet");
    const std::optional<double> result = timing->query.try_milliseconds();
    if (result) {
        idle_queries_.push_back(std::move(timing->query));
        timings_.erase(timing);
    }
    return result;
}

void GlFrameGraphBackend::finish() { gl().Finish(); }

Texture& GlFrameGraphBackend::texture(std::uint32_t id) {
    const auto found = textures_.find(id);
    HACHURE_ASSERT(found != textures_.end(), "an id of a living texture");
    return found->second;
}

const Framebuffer& GlFrameGraphBackend::framebuffer(std::initializer_list<std::uint32_t> colors, std::uint32_t depth) {
    std::vector<std::uint32_t> key{depth};
    key.insert(key.end(), colors);
    const auto found = framebuffers_.find(key);
    if (found != framebuffers_.end()) return found->second;
    std::vector<Attachment> attachments;
    for (const std::uint32_t id : colors) attachments.push_back({id ? &texture(id) : nullptr});
    const Attachment depth_attachment{depth ? &texture(depth) : nullptr};
    return framebuffers_.emplace(key, Framebuffer(attachments, depth_attachment, "frame graph")).first->second;
}

} // namespace hachure::gpu
