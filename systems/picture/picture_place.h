#pragma once

#include <hachure/components/picture.h>
#include <hachure/runtime/gpu/framebuffer.h>

namespace hachure {

/// The pixels of a view that a picture takes: whole ones, so that a picture of the view's own size is shown pixel for
/// pixel. May reach beyond the view.
[[nodiscard]] gpu::Rect picture_place(PictureFit fit, int width, int height, int view_width, int view_height);

/// The part of a place that is in view; empty when none is.
[[nodiscard]] gpu::Rect cut_to_view(const gpu::Rect& place, int view_width, int view_height);

} // namespace hachure
