#pragma once

#include <hachure/runtime/gpu/frame_graph.h>
#include <hachure/runtime/gpu/frame_graph_declaration.h>
#include <hachure/runtime/gpu/frame_graph_kept.h>
#include <hachure/runtime/gpu/frame_graph_pool.h>
#include <hachure/runtime/gpu/frame_graph_timers.h>

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace hachure::gpu {

/// Where a graph is in its frame.
enum class FrameGraphPhase : std::uint8_t { idle, declaring, setup, compiled, executed };

/// What is behind FrameGraph.
struct FrameGraph::State {
    explicit State(FrameGraphBackend& graph_backend) : backend(graph_backend), pool(graph_backend), kept(pool) {}

    /// Throws FrameGraphError unless the graph is in `expected`; `call` is what was called.
    void check_phase(FrameGraphPhase expected, std::string_view call) const;

    void declare_stats();
    void update_gpu_times();

    void execute();
    void age();
    void place_textures();
    void run_pass(std::uint32_t index);
    void acquire(detail::TextureNode& texture);
    void finish_texture(const detail::TextureNode& texture);

    FrameGraphBackend& backend;
    FrameGraphPhase phase = FrameGraphPhase::idle;

    // Of this frame.
    detail::FrameDeclaration frame;
    std::map<std::string, TextureHandle, std::less<>> published;
    std::vector<PassStats> stats;
    std::size_t unshared_bytes = 0;

    // Over frames.
    detail::TexturePool pool;
    detail::KeptResults kept;
    detail::PassTimers timers;
    std::vector<std::uint32_t> transients; // acquired and not yet released
};

} // namespace hachure::gpu
