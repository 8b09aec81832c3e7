#pragma once

#include <hachure/runtime/assets/model.h>

#include <string>
#include <string_view>
#include <vector>

namespace hachure {

/// A line of `hachure info`.
struct ReportRow {
    std::string name;
    std::string value;
};

/// What a model holds: triangles, vertices, joints, clips, morph targets, extensions, bounds at rest; and the health of
/// its surfaces.
[[nodiscard]] std::vector<ReportRow> report_model(std::string_view file, const assets::Model& model);

} // namespace hachure
