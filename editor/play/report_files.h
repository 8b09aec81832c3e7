#pragma once

#include <span>

namespace hachure::play {

/// A file of editor/play/report/ that is part of every report.
struct ReportFile {
    const char* name; ///< "report.css"
    const char* text;
};

/// All of them, sorted by name. The build generates it.
[[nodiscard]] std::span<const ReportFile> report_files();

} // namespace hachure::play
