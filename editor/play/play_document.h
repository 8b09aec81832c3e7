#pragma once

#include <hachure/editor/assignments.h>
#include <hachure/editor/play/expectation.h>
#include <hachure/editor/play/play_input.h>
#include <hachure/runtime/assets/frame_rate.h>
#include <hachure/runtime/gpu/context.h>
#include <hachure/runtime/scene/view.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace hachure::play {

/// A playback test, read and checked: what to open, what to do to it, what must come of it. docs/playback.md has the
/// format.
struct PlayDocument {
    std::filesystem::path file;    ///< the .play.json
    std::filesystem::path folder;  ///< of it: what paths in it are relative to
    std::string doc;               ///< one line; may be empty
    std::filesystem::path scene;   ///< a scene, a model, an image or a video
    std::string style;             ///< a name or a preset file; empty for the scene's own, else gooch
    std::vector<std::string> sets; ///< PATH=VALUE
    assets::FrameRate fps{60, 1};
    Canvas size{320, 240};
    std::uint64_t seed = 1;
    std::int64_t frames = 1; ///< 0 to frames - 1 are played
    gpu::Backend backend = gpu::Backend::automatic;
    std::string clip; ///< of a bare model; empty for its first
    InputByFrame input;
    std::vector<std::unique_ptr<Expectation>> expectations;
};

/// Reads a test. `types` are those of the program that plays it. Throws Error with line and column for JSON that is
/// broken, for unknown keys, and for values that make no sense. Each document is played once: its expectations
/// remember.
[[nodiscard]] PlayDocument read_play(const TypeRegistry& types, const std::filesystem::path& file);

/// The same from a text; `file` names it and says where its folder is.
[[nodiscard]] PlayDocument parse_play(const TypeRegistry& types, const std::filesystem::path& file, std::string text);

/// All that is wrong with a test, one line each with line and column, not only the first thing; none when it is fine.
/// Files that it names are not opened, but for its recording.
[[nodiscard]] std::vector<std::string> play_faults(const TypeRegistry& types, const std::filesystem::path& file);

} // namespace hachure::play
