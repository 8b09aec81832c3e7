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
    int frame = 0;               ///< of a video or of numbered images; 0 for an image
    bool has_normal = false;     ///< its file says normals: see picture_normal
    bool has_depth = false;      ///< its file says depth: see picture_depth
    std::uint64_t key = 0;       ///< changes whenever one of the above does, or the file
};

/// The pictures of this frame, the ones behind first. A resource: systems/picture fills it in stage `material`
/// ("picture.collect").
///
/// Who wants their pixels puts a name into FrameRequests::textures in stage `material` and finds a texture of the
/// view's size under it, where the list is not empty; only what is asked for is decoded. A picture in front hides those
/// behind it all over its rect.
/// - `picture_tone` (rg32f): red is the tone (components/picture.h), 1 beside pictures; green is 0. A pixel of a
/// picture
///   that is shown at its own size is its pixel, exactly; where it is scaled, it is the mean of tones over the pixel.
/// - `picture_color` (rgba16f): linear light, premultiplied alpha, 0 beside pictures; here transparent pictures show
///   what is behind.
/// - `picture_normal` (rgba32f): unit normals in the world, as AOV `normal` has them, alpha 1; all 0 where the picture
///   has none, and beside pictures. Those that another renderer wrote (item.has_normal), as it wrote them: its axes are
///   the world's. A default camera, at the origin, looks along -z with y up, so that normals written in its own view's
///   axes fit it; those in the world's fit a camera that stands as it stood there.
/// - `picture_depth` (r32f): metres along the gaze, as AOV `depth` has them (item.has_depth); 1e10 where nothing is,
/// and
///   beside pictures.
/// Normals and depth of a scaled picture are those of the texel nearest to the pixel's middle: a mean would be a
/// surface between two. Surfaces of the scene lie in front of all of these: ask the depth buffer.
struct PictureList {
    std::vector<PictureItem> items;
    std::uint64_t key = 0; ///< changes whenever an item does
};

} // namespace hachure
