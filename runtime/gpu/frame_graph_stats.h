#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace hachure::gpu {

/// What became of a pass in a frame.
enum class PassState : std::uint8_t {
    culled, ///< nobody wanted its results
    reused, ///< its results of an earlier frame still stand
    run,    ///< it was executed
};

[[nodiscard]] constexpr std::string_view to_string(PassState state) {
    switch (state) {
    case PassState::culled:
        return "culled";
    case PassState::reused:
        return "reused";
    case PassState::run:
        return "run";
    }
    return "";
}

/// What a pass cost in a frame; all figures are zero or empty unless it ran.
struct PassStats {
    std::string name;
    PassState state = PassState::culled;
    double cpu_ms = 0; ///< milliseconds in the pass's function

    /// Milliseconds on the GPU. They arrive later: until then these are the pass's latest known ones, of an earlier
    /// frame. FrameGraph::finish() waits for this frame's. Empty when none are known or the back end measures none.
    std::optional<double> gpu_ms;

    std::uint64_t pixels = 0; ///< covered: declared, set by the pass, or those of the largest texture that it writes
    std::uint64_t bytes = 0;  ///< of the textures that it reads and writes, each once
};

/// Texture memory of a frame graph, in bytes by TextureDesc::bytes(); imported textures are not in it.
struct FrameGraphMemory {
    std::size_t textures = 0;       ///< physical textures that exist
    std::size_t physical_bytes = 0; ///< theirs, with the idle ones of the pool
    std::size_t kept_bytes = 0;     ///< of these, what holds results for later frames
    std::size_t unshared_bytes = 0; ///< what this frame's textures would take without sharing
};

} // namespace hachure::gpu
