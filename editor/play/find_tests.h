#pragma once

#include <filesystem>
#include <span>
#include <vector>

namespace hachure::play {

/// The tests that paths name: a file is itself, a folder all *.play.json files in it and below, sorted by path. Each
/// once. Throws Error for a path that is not there, and for a folder without tests.
[[nodiscard]] std::vector<std::filesystem::path> find_tests(std::span<const std::filesystem::path> paths);

} // namespace hachure::play
