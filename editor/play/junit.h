#pragma once

#include <hachure/editor/play/play_result.h>

#include <filesystem>
#include <span>
#include <string>

namespace hachure::play {

/// Results as JUnit's XML, which continuous integration reads: a test case per expectation in a test suite per file.
/// What an expectation says is a failure, everything else that goes wrong an error.
[[nodiscard]] std::string junit_xml(std::span<const PlayResult> results);

/// Writes that, whole or not at all. Throws Error.
void write_junit(const std::filesystem::path& file, std::span<const PlayResult> results);

} // namespace hachure::play
