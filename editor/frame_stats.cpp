#include <hachure/editor/frame_stats.h>
#include <hachure/runtime/assets/atomic_file.h>
#include <hachure/runtime/scene/draw_list.h>
#include <hachure/runtime/scene/mesh_store.h>
#include <hachure/systems/animation/animation.h>
#include <hachure/systems/curvature/curvature.h>
#include <hachure/systems/deform/deform.h>
#include <hachure/systems/shade_strokes/shade_counts.h>

#include <nlohmann/json.hpp>

#include <array>
#include <string_view>

namespace hachure {
namespace {

using nlohmann::json;

constexpr std::array<std::string_view, 15> count_names{
    "entities",       "surfaces_drawn",        "triangles_drawn",       "models_animated",
    "clips_sampled",  "surfaces_deformed",     "vertices_deformed",     "surfaces_deformed_on_gpu",
    "shade_chains",   "shade_segments",        "shade_triangles_swept", "shade_triangles_touched",
    "shade_vertices", "curvatures_recomputed", "curvatures_carried"};

json pass_json(const gpu::PassStats& pass) {
    json result{{"name", pass.name},     {"state", std::string(gpu::to_string(pass.state))},
                {"cpu_ms", pass.cpu_ms}, {"gpu_ms", nullptr},
                {"pixels", pass.pixels}, {"bytes", pass.bytes}};
    if (pass.gpu_ms) result["gpu_ms"] = *pass.gpu_ms;
    return result;
}

json frame_json(const FrameStats& frame) {
    json systems = json::array(), passes = json::array();
    for (const auto& [name, ms] : frame.systems) systems.push_back({{"name", name}, {"ms", ms}});
    for (const gpu::PassStats& pass : frame.passes) passes.push_back(pass_json(pass));
    return {{"ms", frame.ms}, {"systems", systems}, {"passes", passes}, {"counts", frame.counts}};
}

} // namespace

std::span<const std::string_view> frame_count_names() { return count_names; }

std::map<std::string, std::uint64_t> frame_counts(const World& world) {
    const DrawList& list = world.resource<DrawList>();
    std::uint64_t triangles = 0;
    for (const DrawItem& item : list.items) triangles += world.resource<MeshStore>().mesh(item.mesh).indices.size() / 3;
    const AnimationCounts& animation = world.resource<AnimationCounts>();
    const DeformCounts& deform = world.resource<DeformCounts>();
    const CurvatureCounts& curvature = world.resource<CurvatureCounts>();
    const ShadeCounts& shade = world.resource<ShadeCounts>();
    const std::array<std::uint64_t, count_names.size()> counts{
        world.size(),          list.items.size(),       triangles,      animation.models,     animation.clips,
        deform.surfaces,       deform.vertices,         deform.on_gpu,  shade.chains,         shade.segments,
        shade.triangles_swept, shade.triangles_touched, shade.vertices, curvature.recomputed, curvature.carried};
    std::map<std::string, std::uint64_t> result;
    for (std::size_t i = 0; i < counts.size(); ++i) result.emplace(count_names[i], counts[i]);
    return result;
}

FrameStats frame_stats(App& app, Renderer& renderer, double ms) {
    FrameStats stats;
    stats.ms = ms;
    for (const SystemTime& time : app.schedule().times()) stats.systems.emplace_back(time.name, time.ms);
    const std::span<const gpu::PassStats> passes = renderer.pass_stats();
    stats.passes.assign(passes.begin(), passes.end());
    stats.counts = frame_counts(app.world());
    return stats;
}

void write_stats(const std::filesystem::path& file, std::span<const FrameStats> frames,
                 const gpu::FrameGraphMemory& memory) {
    json document;
    document["frames"] = json::array();
    for (const FrameStats& frame : frames) document["frames"].push_back(frame_json(frame));
    document["memory"] = {{"textures", memory.textures},
                          {"texture_bytes", memory.physical_bytes},
                          {"kept_bytes", memory.kept_bytes},
                          {"unshared_bytes", memory.unshared_bytes}};
    const std::string text = document.dump(2) + "\n";
    assets::write_file_atomically(file, std::as_bytes(std::span(text.data(), text.size())));
}

} // namespace hachure
