#include <hachure/runtime/scene/view_rects.h>
#include <hachure/systems/implicit_brush/feature_aovs.h>
#include <hachure/systems/implicit_brush/feature_quality.h>
#include <hachure/systems/implicit_brush/select_brushes.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string_view>
#include <unordered_map>
#include <utility>

namespace hachure {
namespace {

/// What can be painted on in this view.
struct Canvases {
    struct Item {
        std::uint32_t object_id = 0;
        gpu::Rect rect;
        float metre = 1.0f; ///< the most pixels that a metre is on it
    };
    std::unordered_map<Entity, Item> items;
    std::uint32_t largest_id = 0;

    void add(Entity entity, const Item& item) {
        items.emplace(entity, item);
        largest_id = std::max(largest_id, item.object_id);
    }
};

Canvases canvases_of(const DrawList& list, const PictureList& pictures, const View& view) {
    Canvases result;
    for (const DrawItem& item : list.items) {
        const float depth = view.eye.w > 0.0f ? item.nearest : 1.0f;
        result.add(item.entity, {item.object_id, item.rect, 1.0f / (view.pixel_size * depth)});
    }
    // A picture has no depth: a metre of it is one at the distance of a metre.
    for (const PictureItem& item : pictures.items)
        result.add(item.entity, {item.object_id, item.rect, 1.0f / view.pixel_size});
    return result;
}

/// What a brush paints on: the one entity, it and all below it, or all that is in view.
struct Target {
    Entity entity = Entity::null;
    bool branch = false;
    bool everything = false;
};

/// An entity's brush on its way to a draw.
struct Painter {
    Entity entity;
    const ImplicitBrush* brush;
    Target target;
};

/// As components/implicit_brush.h says.
Target target_of(Entity entity, const Surface* surface, const Picture* picture, const Camera* camera,
                 const Parent* parent, const Query<With<Camera>>& cameras, const View& view) {
    if (surface || picture) return {entity};
    if (camera) return {.everything = entity == view.camera};
    if (!parent) return {.everything = true};
    if (cameras.contains(parent->entity)) return {.everything = parent->entity == view.camera};
    return {parent->entity, true};
}

/// Those that paint, in order.
std::vector<Painter> painters_of(const PlacedBrushes& brushes, const Query<With<Camera>>& cameras, const View& view) {
    std::vector<Painter> result;
    for (auto [entity, brush, parent, surface, picture, camera] : brushes) {
        if (!draws_anything(brush)) continue;
        const Target target = target_of(entity, surface, picture, camera, parent, cameras, view);
        if (target.everything || target.entity) result.push_back({entity, &brush, target});
    }
    std::ranges::sort(result, [](const Painter& a, const Painter& b) {
        return a.brush->order != b.brush->order ? a.brush->order < b.brush->order : a.entity < b.entity;
    });
    return result;
}

class BrushSelection {
public:
    BrushSelection(const Query<const Children>& branches, Canvases canvases, const View& view, BrushFrame& frame)
        : branches_(branches), view_(view), canvases_(std::move(canvases)), frame_(frame) {}

    void run(std::span<const Painter> painters) {
        for (const Painter& painter : painters) add(painter);
        number_owners();
        for (std::size_t draw = 0; draw < frame_.draws.size(); ++draw) finish(draw);
    }

private:
    void add(const Painter& painter) {
        std::vector<Entity> targets;
        const auto take = [&](Entity entity) {
            if (canvases_.items.contains(entity)) targets.push_back(entity);
        };
        if (painter.target.everything)
            for (const auto& [entity, item] : canvases_.items) targets.push_back(entity);
        else if (painter.target.branch)
            for_branch(painter.target.entity, take);
        else
            take(painter.target.entity);
        if (targets.empty()) return;
        const std::size_t draw = draw_of(*painter.brush);
        painted_[draw].insert(painted_[draw].end(), targets.begin(), targets.end());
    }

    template <class F> void for_branch(Entity top, F&& f) const {
        std::vector<Entity> pending{top};
        while (!pending.empty()) {
            const Entity entity = pending.back();
            pending.pop_back();
            f(entity);
            if (const auto found = branches_.find(entity)) {
                const auto& below = std::get<const Children&>(*found).entities;
                pending.insert(pending.end(), below.begin(), below.end());
            }
        }
    }

    /// The draw of a brush like this one, `order` and all.
    std::size_t draw_of(const ImplicitBrush& brush) {
        const auto found = std::ranges::find(frame_.draws, brush, &BrushDraw::brush);
        if (found != frame_.draws.end()) return static_cast<std::size_t>(found - frame_.draws.begin());
        BrushDraw draw{.brush = brush, .style = brush_style(brush, view_)};
        draw.feature = feature_of(brush);
        if (const auto noise = noise_key(brush, view_)) draw.noise = index_of(frame_.noises, *noise);
        frame_.draws.push_back(draw);
        painted_.emplace_back();
        return frame_.draws.size() - 1;
    }

    /// All that brushes of one key want of their feature is one request.
    std::size_t feature_of(const ImplicitBrush& brush) {
        const FeatureKey key = feature_key(brush, view_);
        auto found = std::ranges::find(frame_.features, key, &FeatureRequest::key);
        if (found == frame_.features.end())
            found = frame_.features.insert(found, {key, std::numeric_limits<float>::max(), 0.0f});
        found->least_height = std::min(found->least_height, least_height(brush));
        return static_cast<std::size_t>(found - frame_.features.begin());
    }

    template <class Key> static std::size_t index_of(std::vector<Key>& keys, const Key& key) {
        const auto found = std::ranges::find(keys, key);
        if (found != keys.end()) return static_cast<std::size_t>(found - keys.begin());
        keys.push_back(key);
        return keys.size() - 1;
    }

    void number_owners() {
        frame_.owner_words = std::max<std::size_t>(1, (frame_.draws.size() + 31) / 32);
        frame_.owners.assign((canvases_.largest_id + 1) * frame_.owner_words, 0u);
        for (std::size_t draw = 0; draw < painted_.size(); ++draw) {
            for (const Entity entity : painted_[draw]) {
                const std::size_t id = canvases_.items.at(entity).object_id;
                frame_.owners[id * frame_.owner_words + draw / 32] |= 1u << (draw % 32);
            }
            frame_.draws[draw].everywhere = std::ranges::all_of(
                canvases_.items, [&](const auto& entry) { return frame_.owns(draw, entry.second.object_id); });
        }
    }

    void finish(std::size_t index) {
        BrushDraw& draw = frame_.draws[index];
        for (const Entity entity : painted_[index]) {
            const Canvases::Item& item = canvases_.items.at(entity);
            draw.radius = std::max(draw.radius, largest_radius(draw.brush, view_, item.metre));
            const float counting = weight_reach(draw.brush, view_, item.metre);
            const float inked = ink_reach(draw.brush, view_, item.metre);
            float& wanted = frame_.features[draw.feature].reach;
            wanted = std::max(wanted, counting);
            draw.stamps = united(draw.stamps, grown(item.rect, static_cast<int>(std::ceil(counting)) + 1, view_));
            draw.rect = united(draw.rect, grown(item.rect, static_cast<int>(std::ceil(inked)) + 1, view_));
        }
        draw.style.scale.z = draw.radius;
        frame_.sought = united(frame_.sought, draw.stamps);
        frame_.rect = united(frame_.rect, draw.rect);
    }

    const Query<const Children>& branches_;
    const View& view_;
    Canvases canvases_;
    BrushFrame& frame_;
    std::vector<std::vector<Entity>> painted_; ///< by draw
};

/// Maps that someone asks for cover the view, and are those of occluding contours where no brush paints.
void add_requested(const View& view, const FrameRequests& requests, BrushFrame& frame) {
    if (!wants_feature_aovs(requests)) return;
    if (frame.features.empty()) frame.features.push_back({feature_key(ImplicitBrush{}, view)});
    FeatureRequest& shown = frame.features[frame.draws.empty() ? 0 : frame.draws.front().feature];
    shown = {shown.key};
    frame.sought = {0, 0, view.width, view.height};
}

} // namespace

void select_brushes(PlacedBrushes brushes, Query<const Children> branches, Query<With<Camera>> cameras,
                    Query<const FeatureImage> qualities, const DrawList& list, const PictureList& pictures,
                    const View& view, FrameRequests& requests, BrushFrame& frame, LineLayer& layer) {
    const auto quality = qualities.find(view.camera);
    frame = {.quality = resolved(quality ? std::get<const FeatureImage&>(*quality) : FeatureImage{})};
    const std::vector<Painter> painters = painters_of(brushes, cameras, view);
    if (!painters.empty()) // frames without brushes allocate nothing for them
        BrushSelection(branches, canvases_of(list, pictures, view), view, frame).run(painters);
    add_requested(view, requests, frame);
    request_feature_sources(list, pictures, frame.features, requests);
    if (!std::ranges::all_of(frame.draws, &BrushDraw::everywhere)) requests.textures.insert("object_id");
    layer.set("implicit_brush", frame.draws.empty() ? gpu::Rect{} : frame.rect);
}

} // namespace hachure
