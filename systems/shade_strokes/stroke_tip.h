#pragma once

#include <hachure/components/shade_strokes.h>

namespace hachure {

/// How a tip draws.
struct StrokeTip {
    float width;        ///< times the component's line width; strokes are as much farther apart
    bool solid = false; ///< strokes get thinner where they are weaker, not fainter
    float lift = 0.0f;  ///< how much lighter a stroke is at its ends than in its middle
    float grain = 0.0f; ///< how much of the paper's tooth a tip shows by itself
};

/// A pencil is lifted where the hand turns; its grain is that of the paper that lines are laid on (systems/paper). Ink
/// is as dark everywhere. Charcoal is broad and skips over the paper's valleys.
[[nodiscard]] constexpr StrokeTip stroke_tip(ShadeTip tip) {
    switch (tip) {
    case ShadeTip::ink:
        return {.width = 1.0f, .solid = true};
    case ShadeTip::charcoal:
        return {.width = 2.5f, .lift = 0.4f, .grain = 0.35f};
    case ShadeTip::pencil:
        break;
    }
    return {.width = 1.0f, .lift = 0.5f};
}

} // namespace hachure
