#pragma once

#include <cstdint>
#include <filesystem>

/// File names that number frames: `out.####.png` is `out.0007.png` for frame 7.
namespace hachure::assets {

/// How many runs of '#' the name of the file has; its folders have none that count.
[[nodiscard]] int count_number_fields(const std::filesystem::path& pattern);

/// The file of frame `number` (0 or more): each run of '#' in the name is replaced by the number, with zeros in front
/// to the length of the run; longer numbers take the room they need. A name without '#' stays as it is.
[[nodiscard]] std::filesystem::path frame_file(const std::filesystem::path& pattern, std::int64_t number);

} // namespace hachure::assets
