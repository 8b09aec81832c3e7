#pragma once

#include <hachure/runtime/assets/model.h>

namespace shading_lines {

/// A trefoil knot of a tube that swells and thins, with ridges along it: folds and bumps of several sizes, which lines
/// of different widths tell apart.
[[nodiscard]] hachure::assets::Model knot_model();

} // namespace shading_lines
