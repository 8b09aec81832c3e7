#include <hachure/runtime/gpu/frame_graph_state.h>

#include <algorithm>
#include <chrono>

namespace hachure::gpu {
namespace {

std::uint64_t default_pixels(const detail::FrameDeclaration& frame, const detail::PassNode& pass) {
    std::uint64_t most = 0;
    for (const detail::TextureUse& use : pass.uses) {
        const TextureDesc& desc = frame.textures[use.texture].desc;
        if (use.writes()) most = std::max(most, std::uint64_t(desc.width) * std::uint64_t(desc.height));
    }
    return most;
}

std::uint64_t used_bytes(const detail::FrameDeclaration& frame, const detail::PassNode& pass) {
    std::uint64_t bytes = 0;
    for (const detail::TextureUse& use : pass.uses) bytes += frame.textures[use.texture].desc.bytes();
    return bytes;
}

} // namespace

void FrameGraph::State::declare_stats() {
    stats.clear();
    for (const detail::PassNode& pass : frame.passes) {
        PassStats& stat = stats.emplace_back();
        stat.name = pass.name;
        stat.state = pass.state;
    }
    unshared_bytes = 0;
    for (const detail::TextureNode& texture : frame.textures) {
        if (texture.owned() && texture.survives()) unshared_bytes += texture.desc.bytes();
    }
}

void FrameGraph::State::update_gpu_times() {
    for (std::size_t i = 0; i < stats.size(); ++i) {
        if (stats[i].state == PassState::run) stats[i].gpu_ms = timers.latest(frame.passes[i]);
    }
}

void FrameGraph::State::execute() {
    timers.collect(backend);
    place_textures();
    try {
        for (std::size_t i = 0; i < frame.passes.size(); ++i) {
            if (frame.passes[i].state == PassState::run) run_pass(static_cast<std::uint32_t>(i));
        }
    } catch (...) {
        age(); // memory stays bounded, however many frames fail
        throw;
    }
    age();
    update_gpu_times();
}

void FrameGraph::State::age() {
    kept.end_frame(idle_frames);
    pool.end_frame(idle_frames);
    timers.end_frame(idle_frames);
}

/// Gives the textures of earlier frames to this one, or back to the pool.
void FrameGraph::State::place_textures() {
    for (const std::uint32_t id : transients) pool.release(id); // required by the previous frame, or left by a failure
    transients.clear();
    for (detail::TextureNode& texture : frame.textures) {
        if (!texture.survives()) continue;
        if (!texture.kept) {
            kept.drop(texture);
        } else if (const auto id = kept.reuse(texture)) {
            texture.id = id;
        } else if (!texture.owned()) {
            kept.keep(texture, *texture.id);
        }
    }
    for (const detail::PassNode& pass : frame.passes) {
        if (pass.side_effect) kept.reuse_effect(pass);
    }
}

void FrameGraph::State::acquire(detail::TextureNode& texture) {
    if (texture.id) return; // kept from an earlier frame
    texture.id = pool.acquire(texture.desc, texture.name);
    if (texture.kept) {
        kept.keep(texture, *texture.id);
    } else {
        transients.push_back(*texture.id);
    }
}

/// After the last pass that uses the texture.
void FrameGraph::State::finish_texture(const detail::TextureNode& texture) {
    if (!texture.owned() || texture.kept || texture.required) return;
    pool.release(*texture.id);
    std::erase(transients, *texture.id);
}

void FrameGraph::State::run_pass(std::uint32_t index) {
    detail::PassNode& pass = frame.passes[index];
    for (const detail::TextureUse& use : pass.uses) {
        if (use.access == detail::Access::create) acquire(frame.textures[use.texture]);
    }
    PassContext context(frame, index, pass.pixels ? *pass.pixels : default_pixels(frame, pass));

    const auto begin = std::chrono::steady_clock::now();
    timers.expect(pass, backend.begin_pass(pass.name));
    try {
        pass.body->execute(context);
    } catch (...) {
        backend.end_pass();
        throw;
    }
    backend.end_pass();
    const std::chrono::duration<double, std::milli> elapsed = std::chrono::steady_clock::now() - begin;
    stats[index].cpu_ms = elapsed.count();
    stats[index].pixels = context.pixels_;
    stats[index].bytes = used_bytes(frame, pass);

    if (pass.side_effect) kept.finish_effect(pass);
    for (const detail::TextureUse& use : pass.uses) {
        const detail::TextureNode& texture = frame.textures[use.texture];
        if (use.writes() && texture.kept && use.version == texture.last_version) kept.finish(texture);
        if (texture.last_use == index) finish_texture(texture);
    }
}

} // namespace hachure::gpu
