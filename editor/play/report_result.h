#pragma once

#include <hachure/editor/play/play_result.h>

#include <cstddef>
#include <string>

namespace hachure::play {

/// The part of the page for test number `index` of it: a line, and folded below it, unless it failed, all that is known
/// of it.
[[nodiscard]] std::string html_result(const PlayResult& result, std::size_t index);

/// "walk" for "tests/walk.play.json".
[[nodiscard]] std::string test_name(const PlayResult& result);

/// Whether it wrote golden pictures.
[[nodiscard]] bool has_renewed(const PlayResult& result);

} // namespace hachure::play
