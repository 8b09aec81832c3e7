#pragma once

#include <cstdint>

namespace hachure {

class App;

/// How many surfaces got new curvatures in the last frame. A resource.
struct CurvatureCounts {
    std::uint64_t recomputed = 0;
    std::uint64_t carried = 0;
};

/// Surfaces that carry a Curvature get their PrincipalCurvatures, and new ones when their shape changes. Nothing is
/// computed for others.
void register_curvature(App& app);

} // namespace hachure
