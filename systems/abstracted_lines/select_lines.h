#pragma once

#include <hachure/components/abstracted_lines.h>
#include <hachure/components/tone_image.h>
#include <hachure/runtime/ecs/schedule.h>
#include <hachure/runtime/scene/draw_list.h>
#include <hachure/runtime/scene/frame_requests.h>
#include <hachure/runtime/scene/line_layer.h>
#include <hachure/runtime/scene/picture_list.h>
#include <hachure/runtime/scene/view.h>
#include <hachure/systems/abstracted_lines/tone_line_frame.h>

#include <unordered_set>

namespace hachure {

/// Finds out what lines this frame has, how wide they are and where they can be.
class SelectToneLines {
public:
    void operator()(Query<const AbstractedLines> styled, Query<const ToneImage> qualities, const DrawList& list,
                    const PictureList& pictures, const View& view, FrameRequests& requests, ToneLineFrame& frame,
                    LineLayer& layer);

private:
    /// The lines of a surface or a picture: its entity, its object id, where it can be seen.
    void add(Entity entity, std::uint32_t object_id, const gpu::Rect& rect, const AbstractedLines& lines,
             const View& view, ToneLineFrame& frame);
    void add_pictures(const Query<const AbstractedLines>& styled, const PictureList& pictures, const View& view,
                      ToneLineFrame& frame);
    void warn_of_thin_lines(Entity entity, float width);

    std::unordered_set<Entity> warned_;
};

} // namespace hachure
