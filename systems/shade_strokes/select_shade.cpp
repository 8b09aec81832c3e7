#include <hachure/runtime/app/log.h>
#include <hachure/runtime/assets/image_file.h>
#include <hachure/runtime/gpu/frame_graph_key.h>
#include <hachure/runtime/parallel.h>
#include <hachure/runtime/scene/view_rects.h>
#include <hachure/systems/shade_strokes/component_settings.h>
#include <hachure/systems/shade_strokes/select_shade.h>

#include <fmt/format.h>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace hachure {
namespace {

bool draws_anything(const ShadeStrokes& style) { return style.line_width > 0.0f && style.opacity > 0.0f; }

ShadeEye shade_eye(const View& view) {
    return {.place = glm::vec3(view.eye), .axis = view.backward, .perspective = view.eye.w > 0.0f};
}

/// What of a style strokes are drawn by; what chains are laid by changes them (KeptShade::version).
void add_style(gpu::KeyHash& hash, const ShadeStrokes& style, float time) {
    for (const float value : {style.intensity, style.density, style.line_width, style.opacity, style.flicker})
        hash.add(value);
    hash.add(style.color);
    hash.add(style.tip);
    hash.add(flicker_tick(style, time));
}

} // namespace

void SelectShade::operator()(StyledSurfaces styled, Removed<ShadeStrokes> bare,
                             Query<const ShadeVolume, const WorldTransform> volumes, const DrawList& list,
                             const MeshStore& store, const LightList& lights, const LightStrength& strength,
                             const View& view, const Time& time, ShadeFrame& frame, ShadeNeeds& needs,
                             ShadeCounts& counts, LineLayer& layer) {
    for (const Entity entity : bare)
        if (!styled.contains(entity)) kept_.erase(entity);
    if (!bare.empty()) meshes_.forget_unused();
    counts = {};
    frame.surfaces.clear();
    needs.surfaces.clear();
    needs.key = 0;
    frame.time = static_cast<float>(time.elapsed);
    frame.rect = {};
    frame.key = 0;
    if (!styled.empty()) {
        find_surfaces(styled, list, store);
        place_volumes(volumes);
        step(list, store, lights, strength.strongest, view);
        count(list, store, counts);
        fill(list, view, frame);
        fill_needs(list, needs);
        if (meshes_.size() > kept_.size()) meshes_.forget_unused(); // of other settings than now
    }
    layer.set("shade_strokes", frame.rect);
}

void SelectShade::find_surfaces(const StyledSurfaces& styled, const DrawList& list, const MeshStore& store) {
    shaded_.clear();
    for (std::size_t i = 0; i < list.items.size(); ++i) {
        const DrawItem& item = list.items[i];
        const auto found = styled.find(item.entity);
        if (!found || store.mesh(item.mesh).indices.empty()) continue;
        const auto& [self, style, asked, curvature] = *found;
        if (!draws_anything(style)) continue;
        std::unique_ptr<KeptShade>& kept = kept_[item.entity];
        if (!kept) kept = std::make_unique<KeptShade>();
        meshes_.want(store, item.mesh, style.cells);
        shaded_.push_back({i, &style, asked, curvature, kept.get()});
    }
    meshes_.make_wanted();
}

void SelectShade::place_volumes(const Query<const ShadeVolume, const WorldTransform>& volumes) {
    volumes_.clear();
    const auto asks = [](const Shaded& shaded) { return shaded.style->density_by == ShadeDensityBy::volumes; };
    if (std::ranges::none_of(shaded_, asks)) return;
    std::vector<std::pair<Entity, PlacedVolume>> found;
    for (auto [entity, volume, place] : volumes) {
        // What is flattened holds nothing.
        const float size = std::abs(glm::determinant(place.matrix));
        if (size > 0.0f && std::isfinite(size)) found.push_back({entity, {volume, glm::inverse(place.matrix)}});
    }
    std::ranges::sort(found, {}, [](const auto& entry) { return entry.first; });
    for (const auto& entry : found) volumes_.push_back(entry.second);
}

const assets::Image* SelectShade::picture_of(const ShadeStrokes& style) {
    if (style.density_by != ShadeDensityBy::texture || style.density_texture.empty()) return nullptr;
    const auto found = pictures_.find(style.density_texture);
    if (found != pictures_.end()) return &found->second;
    return &pictures_.emplace(style.density_texture, assets::read_image(style.density_texture)).first->second;
}

void SelectShade::step(const DrawList& list, const MeshStore& store, const LightList& lights, float strongest,
                       const View& view) {
    inputs_.clear();
    for (const Shaded& shaded : shaded_) {
        const DrawItem& item = list.items[shaded.item];
        inputs_.push_back({.item = &item,
                           .surface = &store.mesh(item.mesh),
                           .style = shaded.style,
                           .mesh = meshes_.get(item.mesh, shaded.style->cells),
                           .lights = lights.lights,
                           .strongest = strongest,
                           .eye = shade_eye(view),
                           .picture = picture_of(*shaded.style),
                           .volumes = volumes_,
                           .asked = shaded.curvature_asked,
                           .curvature = shaded.curvature});
    }
    parallel_for(shaded_.size(), [this](std::size_t i) { shaded_[i].kept->step(inputs_[i]); });
    inputs_.clear(); // so that nobody but the strokes holds a mesh
    warn_of_lights();
}

void SelectShade::warn_of_lights() {
    const auto ignores = [](const Shaded& shaded) { return shaded.kept->ignored_lights() > 0; };
    if (warned_ || std::ranges::none_of(shaded_, ignores)) return;
    warned_ = true;
    log_warning("shade_strokes: a light with a value that is no number sheds none");
}

void SelectShade::count(const DrawList& list, const MeshStore& store, ShadeCounts& counts) const {
    for (const Shaded& shaded : shaded_) {
        const KeptShade& kept = *shaded.kept;
        if (kept.swept()) counts.triangles_swept += store.mesh(list.items[shaded.item].mesh).indices.size() / 3;
        counts.triangles_touched += kept.triangles_touched();
        counts.begun += kept.swept() ? kept.stats().begun : 0;
        counts.chains += kept.chains().chains.live();
        counts.segments += kept.chains().segments.live();
        counts.vertices += kept.chains().nodes.live();
    }
}

void SelectShade::fill(const DrawList& list, const View& view, ShadeFrame& frame) const {
    gpu::KeyHash key;
    for (const Shaded& shaded : shaded_) {
        const DrawItem& item = list.items[shaded.item];
        KeptShade& kept = *shaded.kept;
        frame.surfaces.push_back({item.entity, shaded.item, *shaded.style, &kept.mesh(), &kept.chains(),
                                  kept.narrowing(), kept.narrowing_version(), item.world_from_entity});
        // Strokes are as wide as they are on both sides of what they shade; charcoal leaves crumbs beside them.
        const float beside = std::min(2.0f * shaded.style->line_width, 256.0f);
        frame.rect = united(frame.rect, grown(item.rect, static_cast<int>(std::ceil(beside)) + 2, view));
        key.add(item.object_id);
        key.add(item.shape.version);
        key.add(item.world_from_entity);
        key.add(kept.version());
        add_style(key, *shaded.style, frame.time);
    }
    frame.key = key.value();
}

void SelectShade::fill_needs(const DrawList& list, ShadeNeeds& needs) const {
    gpu::KeyHash key;
    for (const Shaded& shaded : shaded_) {
        const KeptShade& kept = *shaded.kept;
        needs.surfaces.push_back({kept.needed(), kept.positions()});
        key.add(list.items[shaded.item].object_id);
        key.add(kept.needed_version());
    }
    needs.key = key.value();
}

} // namespace hachure
