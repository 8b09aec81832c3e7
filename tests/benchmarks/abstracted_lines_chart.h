#pragma once

#include <filesystem>

namespace hachure::bench {

/// Error against cost for every knob of finding lines. CSV for abstracted_lines_chart.gp: panel,series,label,x,y.
/// `quick` takes a small picture and few lines.
void write_abstracted_lines_chart(const std::filesystem::path& path, bool quick);

} // namespace hachure::bench
