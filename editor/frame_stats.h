#pragma once

#include <hachure/runtime/app/app.h>
#include <hachure/runtime/gpu/frame_graph_stats.h>
#include <hachure/runtime/scene/renderer.h>

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace hachure {

/// Wall-clock time since it was made.
class FrameClock {
public:
    [[nodiscard]] double milliseconds() const {
        return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start_).count();
    }

private:
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// What one frame did and cost.
struct FrameStats {
    double ms = 0.0;
    std::vector<std::pair<std::string, double>> systems; ///< name and milliseconds
    std::vector<gpu::PassStats> passes;
    std::map<std::string, std::uint64_t> counts;
};

/// How many things are in the world and were drawn in the last frame, by the names of `frame_count_names`.
[[nodiscard]] std::map<std::string, std::uint64_t> frame_counts(const World& world);

/// What is counted: "entities", "surfaces_drawn", "triangles_drawn", ...
[[nodiscard]] std::span<const std::string_view> frame_count_names();

/// Of the frame that the renderer drew last, which took `ms`; waits for the GPU's timers.
[[nodiscard]] FrameStats frame_stats(App& app, Renderer& renderer, double ms);

/// Writes `--stats`'s JSON. The file appears whole or not at all. Throws Error.
void write_stats(const std::filesystem::path& file, std::span<const FrameStats> frames,
                 const gpu::FrameGraphMemory& memory);

} // namespace hachure
