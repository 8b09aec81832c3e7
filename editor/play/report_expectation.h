#pragma once

#include <hachure/editor/play/play_result.h>

#include <string>

namespace hachure::play {

/// One expectation: a line that says how it went, and below it the pictures to compare, the frames to play and the
/// curves; open where it failed.
[[nodiscard]] std::string html_expectation(const ExpectationResult& expectation);

} // namespace hachure::play
