#include <hachure/components/picture.h>
#include <hachure/runtime/scene/picture_tones.h>
#include <hachure/runtime/scene/render_context.h>
#include <hachure/runtime/scene/view_rects.h>
#include <hachure/systems/implicit_brush/optical_flow.h>
#include <hachure/systems/implicit_brush/picture_phases.h>

#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace hachure {
namespace {

void draw_tone(World& world, RenderContext& render, const PictureItem& item, int frame, std::uint32_t to) {
    PictureItem part = item;
    part.frame = frame;
    part.place.x -= item.rect.x;
    part.place.y -= item.rect.y;
    part.rect = {0, 0, item.rect.width, item.rect.height};
    render.backend->framebuffer({to}).bind();
    world.resource<PictureTones>().draw(world, part);
}

/// Fills a map with places as they are, or with where they were a frame ago by an earlier map.
void carry(RenderContext& render, std::uint32_t to, std::uint32_t from, std::uint32_t flow) {
    const gpu::Framebuffer& framebuffer = render.backend->framebuffer({to});
    framebuffer.bind();
    gpu::apply({.viewport = {0, 0, framebuffer.width(), framebuffer.height()}});
    gpu::ProgramSource source{.vertex = "common/full_screen.vert", .fragment = "implicit_brush/flow_carry.frag"};
    if (from == 0)
        source.defines.push_back({"START", ""});
    else {
        render.backend->texture(from).bind(0);
        render.backend->texture(flow).bind(1);
    }
    render.shaders->program(source).use();
    render.full_screen.draw();
}

/// Random shift and weight of a phase in a frame.
glm::vec4 phase_in(Entity entity, int frame, int lifetime, int phase) {
    const int time = frame + phase * lifetime / 2;
    const glm::vec2 shift =
        random_shift(entity, static_cast<std::size_t>(phase), static_cast<std::uint64_t>(time / lifetime));
    return {shift, std::sin(glm::pi<float>() * static_cast<float>(time % lifetime) / static_cast<float>(lifetime)),
            0.0f};
}

} // namespace

int phase_start(int frame, int lifetime, int phase) {
    return std::max(0, frame - (frame + phase * lifetime / 2) % lifetime);
}

void PicturePhases::make(RenderContext& render, Track& track, const std::vector<int>& lifetimes) {
    const auto texture = [&](const gpu::TextureDesc& desc) { return render.backend->create_texture(desc, "flow"); };
    const int width = track.rect.width, height = track.rect.height;
    for (std::uint32_t& tone : track.tone) tone = texture({width, height, gpu::Format::r32f});
    track.flow = texture(OpticalFlowJob::flow_desc(width, height));
    const gpu::TextureDesc map{width, height, gpu::Format::rg32f};
    track.spare = texture(map);
    for (const int lifetime : lifetimes) track.maps[lifetime] = {texture(map), texture(map)};
    for (const gpu::TextureDesc& desc : OpticalFlowJob::scratch(width, height)) track.scratch.push_back(texture(desc));
}

void PicturePhases::forget(RenderContext& render, const Track& track) {
    std::vector<std::uint32_t> textures = track.scratch;
    textures.insert(textures.end(), {track.tone[0], track.tone[1], track.flow, track.spare});
    for (const auto& [lifetime, maps] : track.maps) textures.insert(textures.end(), maps.begin(), maps.end());
    for (const std::uint32_t id : textures) render.backend->destroy_texture(id);
}

/// The track of a picture; a new one where the picture is another one, or elsewhere, or lives for another time.
PicturePhases::Track& PicturePhases::track_of(const World& world, RenderContext& render, const PictureItem& item) {
    const std::string& file = world.get<Picture>(item.entity).file;
    const auto found = tracks_.find(item.entity);
    if (found != tracks_.end()) {
        Track& track = found->second;
        const bool wanted = track.maps.size() == lifetimes_.size() &&
                            std::ranges::all_of(lifetimes_, [&](int t) { return track.maps.contains(t); });
        if (wanted && track.file == file && track.place == item.place && track.rect == item.rect) return track;
        forget(render, track);
        tracks_.erase(found);
    }
    Track& track = tracks_[item.entity];
    track.file = file;
    track.place = item.place;
    track.rect = item.rect;
    make(render, track, lifetimes_);
    return track;
}

void PicturePhases::follow(World& world, RenderContext& render, const PictureItem& item, Track& track) {
    if (track.frame == item.frame) return;
    int first = item.frame;
    for (const auto& [lifetime, maps] : track.maps)
        for (const int phase : {0, 1}) first = std::min(first, phase_start(item.frame, lifetime, phase));
    if (track.frame < first || track.frame > item.frame) {
        draw_tone(world, render, item, first, track.tone[0]);
        for (const auto& [lifetime, maps] : track.maps)
            for (const std::uint32_t map : maps) carry(render, map, 0, 0);
        track.frame = first;
    }
    for (int frame = track.frame + 1; frame <= item.frame; ++frame) {
        std::swap(track.tone[0], track.tone[1]);
        draw_tone(world, render, item, frame, track.tone[0]);
        OpticalFlowJob{track.tone[1], track.tone[0], track.flow}.run(render, track.scratch);
        for (auto& [lifetime, maps] : track.maps)
            for (const int phase : {0, 1}) {
                std::uint32_t& map = maps[static_cast<std::size_t>(phase)];
                carry(render, track.spare, phase_start(frame, lifetime, phase) == frame ? 0 : map, track.flow);
                std::swap(map, track.spare);
            }
        track.frame = frame;
    }
}

void PicturePhases::draw_map(RenderContext& render, const PictureItem& item, const Maps& maps, int lifetime,
                             const PhaseTextures& textures, const gpu::Rect& rect) {
    const gpu::Framebuffer& framebuffer = render.backend->framebuffer({textures.pasts[0], textures.pasts[1]});
    framebuffer.bind();
    gpu::apply({.viewport = {0, 0, framebuffer.width(), framebuffer.height()}, .scissor = rect});
    gpu::Program& program =
        render.shaders->program({.vertex = "common/full_screen.vert", .fragment = "implicit_brush/picture_past.frag"});
    program.set("corner", glm::ivec2(item.rect.x, item.rect.y));
    const std::array phases{phase_in(item.entity, item.frame, lifetime, 0),
                            phase_in(item.entity, item.frame, lifetime, 1)};
    program.set("phase", std::span<const glm::vec4>(phases));
    for (GLuint k = 0; k < 2; ++k) render.backend->texture(maps[k]).bind(k);
    program.use();
    render.full_screen.draw();
}

void PicturePhases::draw(World& world, RenderContext& render, int lifetime, const PhaseTextures& textures,
                         const gpu::Rect& rect) {
    const PictureList* list = world.find_resource<PictureList>();
    if (!list || !world.find_resource<PictureTones>()) return;
    std::erase_if(tracks_, [&](const auto& entry) {
        const bool gone = std::ranges::find(list->items, entry.first, &PictureItem::entity) == list->items.end();
        if (gone) forget(render, entry.second);
        return gone;
    });
    for (const PictureItem& item : list->items) {
        const gpu::Rect drawn = common(item.rect, rect);
        if (drawn.width <= 0 || drawn.height <= 0) continue;
        Track& track = track_of(world, render, item);
        follow(world, render, item, track);
        draw_map(render, item, track.maps.at(lifetime), lifetime, textures, drawn);
    }
}

} // namespace hachure
