#include <hachure/components/camera.h>
#include <hachure/components/light.h>
#include <hachure/components/rig.h>
#include <hachure/components/scene.h>
#include <hachure/components/surface.h>
#include <hachure/editor/scene_report.h>
#include <hachure/runtime/scene/mesh_store.h>
#include <hachure/systems/capabilities.h>
#include <hachure/systems/scene/load_scene.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <set>
#include <string>

namespace hachure {
namespace {

/// "3: a.glb, b.scene.json", or "0".
std::string listed(std::size_t count, const std::set<std::string>& names) {
    return names.empty() ? fmt::format("{}", count) : fmt::format("{}: {}", count, fmt::join(names, ", "));
}

struct References {
    std::size_t uses = 0;
    std::set<std::string> names;
};

References references(const World& world, bool scenes) {
    References result;
    world.query<const SceneReference>().each([&](const SceneReference& reference) {
        if (reference.is_scene != scenes) return;
        ++result.uses;
        result.names.insert(reference.file.filename().string());
    });
    return result;
}

std::size_t triangles(const World& world) {
    std::size_t count = 0;
    world.query<const Surface>().each(
        [&](const Surface& surface) { count += world.resource<MeshStore>().mesh(surface.mesh).indices.size() / 3; });
    return count;
}

} // namespace

std::vector<ReportRow> report_scene(const std::filesystem::path& file) {
    App app;
    register_capabilities(app);
    const LoadedScene scene = load_scene(app, file);
    const World& world = app.world();
    const SceneDocument& document = world.resource<SceneDocument>();
    const References models = references(world, false), scenes = references(world, true);
    std::set<std::string> looks;
    for (const auto& [name, components] : document.looks.items()) looks.insert(name);
    std::vector<ReportRow> rows{
        {"file", file.string()},
        {"kind", "scene"},
        {"doc", document.doc.empty() ? "none" : document.doc},
        {"style", document.style.empty() ? "none of its own" : document.style},
        {"entities", fmt::format("{} at the root, {} in all", scene.roots.size(), world.size())},
        {"models", listed(models.uses, models.names)},
        {"scenes", listed(scenes.uses, scenes.names)},
        {"looks", listed(looks.size(), looks)},
        {"surfaces", fmt::format("{} of {} triangles", world.query<const Surface>().count(), triangles(world))},
        {"characters", fmt::format("{}", world.query<const Rig>().count())},
        {"cameras", fmt::format("{}", world.query<const Camera>().count())},
        {"lights", fmt::format("{}", world.query<const Light>().count())},
    };
    for (const std::string& warning : scene.warnings) rows.push_back({"warning", warning});
    return rows;
}

} // namespace hachure
