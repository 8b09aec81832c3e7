#pragma once

#include <hachure/editor/play/play_result.h>

#include <filesystem>
#include <span>
#include <string>

namespace hachure::play {

/// Writes `folder`/index.html, one page that shows what playback tests did, failed ones first: it holds its pictures,
/// its style and its scripts, and asks for nothing else. The folder is made where it is missing; the file appears whole
/// or not at all. Pictures that can't be read are said to be missing. Throws Error when the page can't be written.
void write_report(const std::filesystem::path& folder, std::span<const PlayResult> results);

/// The text of that page. The same results and pictures give the same text.
[[nodiscard]] std::string report_page(std::span<const PlayResult> results);

} // namespace hachure::play
