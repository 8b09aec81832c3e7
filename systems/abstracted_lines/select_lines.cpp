#include <hachure/runtime/app/log.h>
#include <hachure/systems/abstracted_lines/select_lines.h>
#include <hachure/systems/abstracted_lines/tone_levels.h>
#include <hachure/systems/abstracted_lines/tone_quality.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace hachure {
namespace {

/// Around lines of this width: what their search looks at, and what the blur of that does.
ToneRects rects_around(const gpu::Rect& lines, float widest, bool whole, const View& view) {
    const gpu::Rect all{0, 0, view.width, view.height};
    if (whole) return {all, all, all};
    if (lines.width <= 0 || lines.height <= 0) return {};
    // A search ends half a width away, and its taps are diagonal.
    const int search = static_cast<int>(std::ceil(1.3f * widest)) + 2;
    const gpu::Rect blurred = grown(lines, search, view);
    return {lines, blurred, grown(blurred, blur_radius(blur_sigma(double(widest))), view)};
}

bool wants_whole_view(const FrameRequests& requests) {
    for (const char* name : {"tone", "tone_specular", "ridge_distance", "ridge_curvature", "line_opacity",
                             "ridge_points", "specular_ridge_points"})
        if (requests.wants(name)) return true;
    return false;
}

} // namespace

void SelectToneLines::warn_of_thin_lines(Entity entity, float width) {
    if (width >= narrowest_search || !warned_.insert(entity).second) return;
    log_warning(fmt::format("abstracted_lines: lines {:.2g} px wide are found as lines of {:.2g} px are, and drawn "
                            "thinner: what lies closer together is one line",
                            width, narrowest_search));
}

void SelectToneLines::add(Entity entity, std::uint32_t object_id, const gpu::Rect& rect, const AbstractedLines& lines,
                          const View& view, ToneLineFrame& frame) {
    const float full = full_width(lines, view), least = least_width(lines, view);
    warn_of_thin_lines(entity, full);
    if (frame.styles.size() <= object_id) frame.styles.resize(object_id + 1);
    frame.styles[object_id] = line_style(lines, view);
    const float narrowest = std::max(least, narrowest_search), widest = std::max(full, narrowest_search);
    frame.narrowest = frame.widest > 0.0f ? std::min(frame.narrowest, narrowest) : narrowest;
    frame.widest = std::max(frame.widest, widest);
    frame.least_curvature = std::min(frame.least_curvature, least_curvature(lines));
    (lines.method == ToneLineMethod::pixels ? frame.pixels : frame.strokes) = true;
    frame.rects.lines = united(frame.rects.lines, rect);
}

/// Nothing makes a picture's lines thinner in places: it has no depth, no edges and no vertices.
void SelectToneLines::add_pictures(const Query<const AbstractedLines>& styled, const PictureList& pictures,
                                   const View& view, ToneLineFrame& frame) {
    for (const PictureItem& item : pictures.items) {
        const auto found = styled.find(item.entity);
        if (!found) continue;
        AbstractedLines lines = std::get<const AbstractedLines&>(*found);
        if (!draws_anything(lines)) continue;
        lines.width_by = LineAbstraction::constant;
        add(item.entity, item.object_id, item.rect, lines, view, frame);
        frame.pictures = true;
    }
}

void SelectToneLines::operator()(Query<const AbstractedLines> styled, Query<const ToneImage> qualities,
                                 const DrawList& list, const PictureList& pictures, const View& view,
                                 FrameRequests& requests, ToneLineFrame& frame, LineLayer& layer) {
    const auto quality = qualities.find(view.camera);
    frame = {.quality = resolved(quality ? std::get<const ToneImage&>(*quality) : ToneImage{})};
    bool all = true;
    for (const DrawItem& item : list.items) {
        const auto found = styled.find(item.entity);
        const AbstractedLines* lines = found ? &std::get<const AbstractedLines&>(*found) : nullptr;
        if (lines && draws_anything(*lines))
            add(item.entity, item.object_id, item.rect, *lines, view, frame);
        else
            all = false;
    }
    add_pictures(styled, pictures, view, frame);
    if (frame.styles.empty()) {
        frame.styles.emplace_back();
        frame.narrowest = frame.widest = narrowest_search;
    }
    frame.only = frame.styles.back();
    const auto alike = [&](const auto& item) {
        return item.object_id < frame.styles.size() && frame.styles[item.object_id] == frame.only;
    };
    frame.uniform = all && std::ranges::all_of(list.items, alike) && std::ranges::all_of(pictures.items, alike);
    frame.varying = frame.narrowest < frame.widest;
    if (frame.pixels || frame.strokes) {
        // Half a line along an outline is outside of it.
        const int outside = static_cast<int>(std::ceil(0.5f * frame.widest)) + 2;
        frame.rects.lines = grown(frame.rects.lines, outside, view);
    }
    frame.rects = rects_around(frame.rects.lines, frame.widest, wants_whole_view(requests), view);
    // Points are of owners, also where all are alike.
    const bool owners = requests.wants("ridge_points") || requests.wants("specular_ridge_points");
    if (!frame.uniform || owners) requests.textures.insert("object_id");
    if (frame.pictures) requests.textures.insert("picture_tone");
    layer.set("abstracted_lines", frame.pixels || frame.strokes ? frame.rects.lines : gpu::Rect{});
}

} // namespace hachure
