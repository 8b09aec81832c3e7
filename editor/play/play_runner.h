#pragma once

#include <hachure/editor/play/play_result.h>
#include <hachure/runtime/gpu/context.h>

#include <cstdint>
#include <filesystem>
#include <optional>

namespace hachure::play {

/// How tests are played.
struct PlayOptions {
    bool update = false;                 ///< write golden pictures anew
    std::int64_t from = 0;               ///< play earlier frames without drawing or looking at them
    std::filesystem::path evidence;      ///< an existing folder for pictures of the report; empty for none
    std::optional<gpu::Backend> backend; ///< instead of the test's own
};

/// Plays a test in this process, on a context of its own. What goes wrong is in the result; nothing is thrown but for
/// our own mistakes. Frames that nothing looks at are played and not drawn.
[[nodiscard]] PlayResult run_play(const std::filesystem::path& file, const PlayOptions& options);

} // namespace hachure::play
