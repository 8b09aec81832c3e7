#pragma once

#include <filesystem>

namespace hachure::bench {

/// Measures every operation that has a panel in the chart, and its floor, for 1e3 to 1e7 entities, or two tiny numbers
/// when `quick`. Writes CSV for ecs_chart.gp: panel,series,entities,ns.
void write_sweep(const std::filesystem::path& path, bool quick);

} // namespace hachure::bench
