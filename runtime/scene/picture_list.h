#pragma once

#include <hachure/runtime/ecs/entity.h>
#include <hachure/runtime/gpu/framebuffer.h>

#include <cstdint>
#include <vector>

namespace hachure {

/// A picture that this frame's view shows.
struct PictureItem {
    Entity entity;
    std::uint32_t object_id = 0; ///< AOV `object_id`, as DrawItem has it
    gpu::Rect place;             ///< pixels of the view that the whole picture takes; may reach beyond it
    gpu::Rect rect;              ///< the part of `place` that is in view, not empty
    int frame = 0;               ///< of a video; 0 for an image
    std::uint64_t key = 0;       ///< changes whenever one of the above does, or the file
};

/// The pictures of this frame, the ones behind first. A resource: systems/picture fills it in stage `material`
/// ("picture.collect").
///
/// Who wants their pixels puts a name into FrameRequests::textures in stage `material` and finds a texture of the
/// view's size under it, where the list is not empty:
/// - `picture_tone` (rg32f): red is the tone (components/picture.h), 1 beside pictures; green is 0. A pixel of a
/// picture
///   that is shown at its own size is its pixel, exactly; where it is scaled, it is the mean of tones over the pixel.
/// - `picture_color` (rgba16f): linear light, premultiplied alpha, 0 beside pictures.
struct PictureList {
    std::vector<PictureItem> items;
    std::uint64_t key = 0; ///< changes whenever an item does
};

} // namespace hachure
