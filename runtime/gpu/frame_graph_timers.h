#pragma once

#include <hachure/runtime/gpu/frame_graph_backend.h>
#include <hachure/runtime/gpu/frame_graph_declaration.h>

#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

namespace hachure::gpu::detail {

/// GPU times of passes, which arrive frames after the passes ran.
class PassTimers {
public:
    /// Waits for the time under `ticket`, which is 0 for an untimed pass.
    void expect(const PassNode& pass, std::uint64_t ticket);

    /// Takes in what has arrived, without waiting.
    void collect(FrameGraphBackend& backend);

    /// The latest known time of a pass of this name, in milliseconds.
    [[nodiscard]] std::optional<double> latest(const PassNode& pass) const;

    /// Ends a frame: forgets passes that have not run for `idle_frames` frames.
    void end_frame(std::uint32_t idle_frames);

private:
    struct Pending {
        std::uint64_t ticket = 0;
        std::uint64_t pass = 0; // key of the name
    };

    struct Time {
        std::optional<double> milliseconds;
        std::uint32_t idle = 0; // whole frames without a run
    };

    std::vector<Pending> pending_; // oldest first
    std::unordered_map<std::uint64_t, Time> times_;
};

} // namespace hachure::gpu::detail
