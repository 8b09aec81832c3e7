#pragma once

#include <cstdint>

namespace hachure {

/// How far a pixel looks for a line on either side.
struct FeatureWindow {
    float length = 6.0f;           ///< px, or metres of what is seen
    std::uint32_t world_depth = 0; ///< with metres: the depth buffer; 0 for px
};

} // namespace hachure
