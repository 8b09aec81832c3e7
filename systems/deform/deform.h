#pragma once

#include <cstdint>

namespace hachure {

class App;

/// What the last frame deformed. A resource.
struct DeformCounts {
    std::uint64_t surfaces = 0;
    std::uint64_t vertices = 0;
};

/// Skinned and morphing surfaces (Skin, MorphWeights) get the shape that their joints and weights give them: a Deformed
/// each. Only those whose joints, weights or settings (Deform) changed are deformed anew; the work is shared by all
/// threads.
void register_deform(App& app);

} // namespace hachure
