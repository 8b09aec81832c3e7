#pragma once

#include <hachure/runtime/ecs/world.h>
#include <hachure/runtime/gpu/frame_graph.h>
#include <hachure/runtime/gpu/rect.h>
#include <hachure/runtime/scene/view_rects.h>

#include <algorithm>
#include <string_view>
#include <vector>

namespace hachure {

/// Where this frame's texture `line_layer` holds lines. A resource; whoever draws lines says where, systems/compose
/// lays only that part over the picture. Who creates the layer clears all of it.
class LineLayer {
public:
    /// Where the capability `who` draws lines in this frame; it stands until the capability says something else.
    void set(std::string_view who, const gpu::Rect& rect) {
        const auto found = std::ranges::find(parts_, who, &Part::who);
        if (found != parts_.end())
            found->rect = rect;
        else
            parts_.push_back({who, rect});
    }

    /// Around all of them.
    [[nodiscard]] gpu::Rect rect() const {
        gpu::Rect rect;
        for (const Part& part : parts_) rect = united(rect, part.rect);
        return rect;
    }

    bool laid = false; ///< in this frame a pass before compose lays lines over the picture, as systems/paper does

private:
    struct Part {
        std::string_view who; ///< a name that outlives the world
        gpu::Rect rect;
    };
    std::vector<Part> parts_;
};

/// The line layer as a pass draws onto it.
struct LineTarget {
    gpu::TextureHandle layer;
    bool first = false; ///< nobody has drawn onto it yet
};

/// Finds the line layer, or makes it (rgba16f, premultiplied, of the view's size), and declares that `pass` draws onto
/// it; publishes the new version.
[[nodiscard]] LineTarget write_line_layer(World& world, gpu::PassBuilder& pass);

/// From within the pass: binds the layer, cleared where it has to be.
void bind_line_layer(World& world, const gpu::PassContext& pass, const LineTarget& target);

} // namespace hachure
