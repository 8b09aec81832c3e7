#pragma once

#include <hachure/runtime/assets/model.h>

namespace samples {

/// The build of a figure.
struct Build {
    float height = 1.8f; ///< metres
    float girth = 1.0f;  ///< 1: of a slim one
};

/// A lay figure as painters have it, of smooth limbs on 11 joints, with the clip "walk": two steps a loop, on the spot.
/// It stands on y = 0 and looks along +Z.
[[nodiscard]] hachure::assets::Model lay_figure(const Build& build);

} // namespace samples
