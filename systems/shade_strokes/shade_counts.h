#pragma once

#include <cstdint>

namespace hachure {

/// What shade strokes took and are in the last frame, over all surfaces in view. A resource.
struct ShadeCounts {
    std::uint64_t triangles_swept = 0;   ///< whose light was looked at: none when nothing moved
    std::uint64_t triangles_touched = 0; ///< in whose cells strokes were changed; once per cell where several share one
    std::uint64_t begun = 0;             ///< chains; the others were there before
    std::uint64_t chains = 0;
    std::uint64_t segments = 0;
    std::uint64_t vertices = 0; ///< nodes of chains; what the GPU makes of them follows from the view
};

} // namespace hachure
