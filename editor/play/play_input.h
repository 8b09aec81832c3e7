#pragma once

#include <hachure/editor/play/json_object.h>
#include <hachure/runtime/app/input.h>

#include <cstdint>
#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace hachure::play {

/// Largest number of frames that a test or a recording may have.
inline constexpr std::int64_t max_frames = 1'000'000;

/// What people do, by frame.
using InputByFrame = std::map<std::int64_t, std::vector<InputEvent>>;

/// Reads an array of events: {"frame": 3, "key_down": "space"}, also key_up, button_down, button_up, and pointer_move
/// and scroll with [x, y]; in any order, those of a frame in theirs. Throws Error with line and column.
[[nodiscard]] InputByFrame parse_input(const assets::JsonText& text, const std::string& pointer,
                                       const nlohmann::json& events);

/// Reads a recording: {"hachure_input": 1, "events": [...]}. Throws Error.
[[nodiscard]] InputByFrame read_recording(const std::filesystem::path& file);

/// Writes one, whole or not at all. Throws Error.
void write_recording(const std::filesystem::path& file, const InputByFrame& input);

} // namespace hachure::play
