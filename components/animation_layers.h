#pragma once

#include <hachure/components/animation.h>

#include <string>
#include <vector>

namespace hachure {

/// A clip that is laid over what a character plays.
struct AnimationLayer {
    std::string clip;
    float weight = 1.0f;   ///< [0, 1]
    bool additive = false; ///< adds what the clip moves from its own first pose, instead of replacing
    std::string mask;      ///< the node that it begins at, with all below; empty for all nodes
    Repeat repeat = Repeat::loop;
    float speed = 1.0f;  ///< clip seconds per second
    float offset = 0.0f; ///< clip seconds that count as played when it begins
    double time = 0.0;   ///< clip seconds that it has played

    friend bool operator==(const AnimationLayer&, const AnimationLayer&) = default;
};

/// Clips over the one that a model's root plays with Animation or AnimationStates, in order. They play while that one
/// does.
struct AnimationLayers {
    std::vector<AnimationLayer> layers;

    friend bool operator==(const AnimationLayers&, const AnimationLayers&) = default;
};

} // namespace hachure
