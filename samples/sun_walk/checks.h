#pragma once

#include <hachure/runtime/assets/image.h>
#include <hachure/runtime/scene/renderer.h>
#include <hachure/samples/common/orbit.h>

#include "day.h"

namespace sun_walk {

/// What must hold of the sample's pictures; each check says on stdout what it measured, and on stderr what is wrong.
class Checks {
public:
    Checks(hachure::World& world, hachure::Renderer& renderer, Day& day);

    /// Draws `frames` frames, a thirtieth of a second apart: in each, strokes change, and few are drawn anew.
    void strokes_follow(int frames);
    /// Shade that strokes deliver is what the light needs, up to the dead band, at any hour.
    void shade_is_delivered();
    /// The lower the sun, the more is covered.
    void night_is_dark();
    /// A camera that turns makes no stroke be looked at.
    void turning_costs_nothing(samples::Orbit& orbit);
    void nothing_moves();

    [[nodiscard]] bool all_hold() const { return hold_; }

private:
    void draw(double seconds = 0.0);
    /// Of an AOV with one channel, over all pixels.
    [[nodiscard]] double mean(const char* aov);
    void check(bool holds, const char* what);

    hachure::World& world_;
    hachure::Renderer& renderer_;
    Day& day_;
    bool hold_ = true;
};

} // namespace sun_walk
