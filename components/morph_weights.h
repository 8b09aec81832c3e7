#pragma once

#include <vector>

namespace hachure {

/// How far each morph target of a surface's mesh is applied.
struct MorphWeights {
    std::vector<float> values; ///< one per target; 0 for not at all, 1 for whole

    friend bool operator==(const MorphWeights&, const MorphWeights&) = default;
};

} // namespace hachure
