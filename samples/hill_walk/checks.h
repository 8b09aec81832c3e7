#pragma once

#include <hachure/runtime/assets/image.h>
#include <hachure/runtime/scene/renderer.h>
#include <hachure/samples/common/orbit.h>

#include "walk.h"

namespace hill_walk {

/// What must hold of the sample's pictures; each check says on stdout what it measured, and on stderr what is wrong.
class Checks {
public:
    Checks(hachure::World& world, hachure::Renderer& renderer, HillWalk& scene);

    /// Draws `frames` frames, a thirtieth of a second apart.
    void figures_move(int frames);
    /// The ink of each part has a colour that no other part's has.
    void brushes_are_their_own();
    /// Contours, ridges and valleys are all in one picture.
    void features_share_a_frame();
    void nothing_moves();
    /// While the camera turns, what is painted with noise of the surface goes with the surface more than what is
    /// painted with noise of the screen.
    void noise_holds_to_the_ground(samples::Orbit& orbit);

    [[nodiscard]] bool all_hold() const { return hold_; }

private:
    /// Linear RGB of the next frame.
    [[nodiscard]] hachure::assets::Image draw(double seconds = 0.0);
    /// The next frame with those brushes alone that `shown(part, brush)` picks.
    template <class F> [[nodiscard]] hachure::assets::Image draw_only(F shown);
    /// How far the pictures of two frames differ along the motion between them, per pixel.
    [[nodiscard]] double drift(hachure::BrushGrain grain, samples::Orbit& orbit);
    void check(bool holds, const char* what);

    hachure::World& world_;
    hachure::Renderer& renderer_;
    HillWalk& scene_;
    bool hold_ = true;
};

} // namespace hill_walk
