#pragma once

#include <hachure/runtime/ecs/world.h>
#include <hachure/runtime/scene/picture_list.h>

#include <functional>

namespace hachure {

/// Resource: tones of any frame of a picture, for those who look at what moves in it. systems/picture sets it.
struct PictureTones {
    /// From within a pass: draws the tone (PictureList's `picture_tone`) of `item.frame`, which need not be the one
    /// that is shown, at `item.place` into `item.rect` of the framebuffer that is bound, which may be another one than
    /// the view's. Frames in order are fast. Throws Error for a frame that can't be decoded.
    std::function<void(World& world, const PictureItem& item)> draw;
};

} // namespace hachure
