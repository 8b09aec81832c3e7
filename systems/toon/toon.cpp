#include <hachure/components/toon.h>
#include <hachure/components/world_transform.h>
#include <hachure/runtime/app/app.h>
#include <hachure/runtime/scene/draw_list.h>
#include <hachure/runtime/scene/mesh_store.h>
#include <hachure/runtime/scene/render_context.h>
#include <hachure/runtime/scene/surface_renderer.h>
#include <hachure/systems/toon/toon.h>
#include <hachure/systems/toon/toon_normals.h>
#include <hachure/systems/toon/toon_passes.h>

#include <memory>

namespace hachure {
namespace {

constexpr std::string_view shading_name = ToonPasses::name;

void claim_items(Query<With<Toon>> styled, const DrawList& list, DrawClaims& claims) {
    for (std::size_t i = 0; i < list.items.size(); ++i)
        if (styled.contains(list.items[i].entity)) claims.shading[i] = shading_name;
}

} // namespace

void register_toon(App& app) {
    app.add_component<Toon>();
    if (!app.world().find_resource<MeshStore>()) app.world().set_resource(MeshStore{});
    app.add_system(Stage::deform, "toon.normals",
                   [system = std::make_shared<ToonNormals>()](ToonSurfaces surfaces, Query<AbstractedNormals> results,
                                                              Removed<Toon> unwanted, LastRun last,
                                                              const MeshStore& store, Commands& commands) {
                       system->update(surfaces, results, unwanted, last, store, commands);
                   })
        .after("deform")
        .after("curvature");
    app.add_system(Stage::material, "toon.claim", claim_items)
        .after("surface.collect")
        .after("gooch.claim")
        .after("metal.claim");
    app.add_system(Stage::render, "toon.pass",
                   [passes = std::make_shared<ToonPasses>()](World& world) { passes->declare(world); })
        .after("surface.passes")
        .after("gooch.pass")
        .after("metal.pass");
}

} // namespace hachure
