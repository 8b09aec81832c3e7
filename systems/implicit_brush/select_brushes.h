#pragma once

#include <hachure/components/camera.h>
#include <hachure/components/feature_image.h>
#include <hachure/components/implicit_brush.h>
#include <hachure/components/picture.h>
#include <hachure/components/surface.h>
#include <hachure/runtime/ecs/hierarchy.h>
#include <hachure/runtime/ecs/schedule.h>
#include <hachure/runtime/scene/draw_list.h>
#include <hachure/runtime/scene/frame_requests.h>
#include <hachure/runtime/scene/line_layer.h>
#include <hachure/runtime/scene/picture_list.h>
#include <hachure/runtime/scene/view.h>
#include <hachure/systems/implicit_brush/brush_frame.h>

namespace hachure {

/// Brushes, with what tells what each of them paints on.
using PlacedBrushes = Query<const ImplicitBrush, Optional<const Parent>, Optional<const Surface>,
                            Optional<const Picture>, Optional<const Camera>>;

/// Finds out which brushes paint in this frame, on what and where, and what they share: fills `frame` and its part of
/// `layer`, and asks for the textures that this takes.
void select_brushes(PlacedBrushes brushes, Query<const Children> branches, Query<With<Camera>> cameras,
                    Query<const FeatureImage> qualities, const DrawList& list, const PictureList& pictures,
                    const View& view, FrameRequests& requests, BrushFrame& frame, LineLayer& layer);

} // namespace hachure
