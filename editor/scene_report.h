#pragma once

#include <hachure/editor/model_report.h>

#include <filesystem>
#include <vector>

namespace hachure {

/// What is in a scene file with all that it refers to. Throws Error where it has a fault.
[[nodiscard]] std::vector<ReportRow> report_scene(const std::filesystem::path& file);

} // namespace hachure
