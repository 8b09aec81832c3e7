#include <hachure/components/compose.h>
#include <hachure/components/deformed.h>
#include <hachure/components/picture.h>
#include <hachure/components/surface.h>
#include <hachure/components/world_transform.h>
#include <hachure/runtime/app/app.h>
#include <hachure/runtime/scene/draw_list.h>
#include <hachure/runtime/scene/mesh_store.h>
#include <hachure/runtime/scene/render_context.h>
#include <hachure/runtime/scene/surface_renderer.h>
#include <hachure/runtime/scene/view.h>
#include <hachure/systems/surface/frustum.h>
#include <hachure/systems/surface/surface.h>

#include <glm/gtc/matrix_inverse.hpp>

#include <algorithm>
#include <utility>

namespace hachure {
namespace {

constexpr std::string_view unlit = "unlit";

DrawShape draw_shape(const Deformed* deformed) {
    if (!deformed) return {};
    return {deformed->positions, deformed->normals, deformed->tangents, deformed->version, deformed->on_gpu};
}

DrawItem draw_item(Entity entity, const Surface& surface, const Deformed* deformed, const glm::mat4& matrix) {
    DrawItem item;
    item.entity = entity;
    item.mesh = surface.mesh;
    item.shape = draw_shape(deformed);
    item.world_from_entity = matrix;
    item.world_from_normal = glm::inverseTranspose(glm::mat3(matrix));
    item.tint = surface.tint;
    item.mirrored = glm::determinant(glm::mat3(matrix)) < 0.0f;
    return item;
}

using PlacedSurfaces = Query<const Surface, const WorldTransform, Optional<const Deformed>>;

/// An item with the bounds of its surface in entity space.
struct BoundedItem {
    DrawItem item;
    geometry::Bounds bounds;
};

/// Object ids number surfaces and pictures together, in the order of entities: they do not depend on what is in view.
void number(std::vector<BoundedItem>& items, std::vector<DrawPicture>& pictures) {
    std::uint32_t id = 0;
    auto picture = pictures.begin();
    for (auto& [item, bounds] : items) {
        for (; picture != pictures.end() && picture->entity < item.entity; ++picture) picture->object_id = ++id;
        item.object_id = ++id;
    }
    for (; picture != pictures.end(); ++picture) picture->object_id = ++id;
}

std::vector<DrawItem> visible_items(const PlacedSurfaces& surfaces, const View& view, const MeshStore& store,
                                    std::vector<DrawPicture>& pictures) {
    std::vector<BoundedItem> items;
    for (auto [entity, surface, transform, deformed] : surfaces)
        if (surface.visible)
            items.push_back({draw_item(entity, surface, deformed, transform.matrix),
                             deformed ? deformed->bounds : store.mesh(surface.mesh).bounds});
    std::ranges::sort(items, {}, [](const BoundedItem& bounded) { return bounded.item.entity; });
    number(items, pictures);
    std::vector<DrawItem> visible;
    for (auto& [item, own_bounds] : items) {
        const geometry::Bounds bounds = transformed(own_bounds, item.world_from_entity);
        if (outside_frustum(bounds, view.clip_from_world)) continue;
        item.rect = screen_rect(bounds, view);
        item.nearest = nearest_depth(bounds, view);
        visible.push_back(item);
    }
    return visible;
}

/// Makes the list anew when a surface changed, or the view did.
class CollectSurfaces {
public:
    void operator()(PlacedSurfaces surfaces, Query<const Picture> pictures, Removed<Surface> bare,
                    Removed<WorldTransform> unplaced, Removed<Deformed> stiff, Removed<Picture> blank, LastRun last,
                    const View& view, const MeshStore& store, DrawList& list, DrawClaims& claims) {
        const bool changed = !surfaces.changed_since<Surface, WorldTransform, Deformed>(last.tick).empty();
        if (changed || !bare.empty() || !unplaced.empty() || !stiff.empty()) ++version_;
        if (!blank.empty() || !pictures.changed_since<Picture>(last.tick).empty()) find_pictures(pictures);
        const std::uint64_t key = gpu::key_of(view.key(), version_);
        if (list.key != key) {
            list.pictures.clear();
            for (const Entity entity : pictures_) list.pictures.push_back({entity});
            list.items = visible_items(surfaces, view, store, list.pictures);
            list.key = key;
        }
        // Who shades an item can change without the list: every capability claims anew.
        claims.shading.assign(list.items.size(), unlit);
    }

private:
    /// A picture that only changes its look changes no object id: surfaces are not drawn again for it.
    void find_pictures(const Query<const Picture>& pictures) {
        std::vector<Entity> found;
        for (auto [entity, picture] : pictures)
            if (picture.visible) found.push_back(entity);
        std::ranges::sort(found);
        if (found == pictures_) return;
        pictures_ = std::move(found);
        ++version_;
    }

    std::uint64_t version_ = 0;    ///< how often surfaces, or which pictures there are, were seen to have changed
    std::vector<Entity> pictures_; ///< the visible ones, ascending
};

gpu::Format color_format(const FrameRequests& requests) {
    return requests.wants("color") ? gpu::Format::rgba32f : gpu::Format::srgb8_alpha8;
}

glm::vec3 background(const World& world) {
    const Compose* compose = world.find<Compose>(world.resource<View>().camera);
    return compose ? compose->background : Compose{}.background;
}

void declare_targets(World& world, RenderContext& render) {
    const View& view = world.resource<View>();
    const FrameRequests& requests = world.resource<FrameRequests>();
    const glm::vec3 clear_color = background(world);
    gpu::FrameGraph& graph = render.graph;
    graph.add_pass<SurfaceTargets>(
        "targets",
        [&](gpu::PassBuilder& pass, SurfaceTargets& targets) {
            const auto create = [&](const char* name, gpu::Format format) {
                const gpu::TextureHandle handle = pass.create(name, {view.width, view.height, format});
                graph.publish(name, handle);
                return handle;
            };
            targets.color = create("color", color_format(requests));
            targets.depth_buffer = create("depth_buffer", gpu::Format::depth32f);
            if (requests.wants("normal")) targets.normal = create("normal", gpu::Format::rgba32f);
            if (requests.wants("object_id")) targets.object_id = create("object_id", gpu::Format::r32ui);
            if (requests.wants("surface_code")) targets.code = create("surface_code", gpu::Format::rg32ui);
            pass.depends_on(clear_color);
        },
        [&render, clear_color](const SurfaceTargets& targets, gpu::PassContext& pass) {
            const gpu::TextureDesc& desc = pass.desc(targets.color);
            gpu::apply({.viewport = {0, 0, desc.width, desc.height},
                        .depth_test = gpu::DepthTest::always,
                        .depth_write = true,
                        .srgb_write = true});
            const auto id = [&](gpu::TextureHandle handle) { return handle ? pass.texture(handle) : 0u; };
            const gpu::Framebuffer& framebuffer = render.backend->framebuffer(
                {pass.texture(targets.color), id(targets.normal), id(targets.object_id), id(targets.code)},
                pass.texture(targets.depth_buffer));
            framebuffer.clear_color(0, std::array{clear_color.r, clear_color.g, clear_color.b, 1.0f});
            if (targets.normal) framebuffer.clear_color(1, std::array{0.0f, 0.0f, 0.0f, 0.0f});
            if (targets.object_id) framebuffer.clear_color(2, std::array{0u, 0u, 0u, 0u});
            if (targets.code) framebuffer.clear_color(3, std::array{0u, 0u, 0u, 0u});
            framebuffer.clear_depth(0.0f);
        });
}

void declare_passes(World& world) {
    RenderContext& render = world.resource_mutable<RenderContext>();
    render.meshes.forget_shapes_but(world.resource<DrawList>().items);
    declare_targets(world, render);
    add_surface_pass(world, {.name = unlit, .fragment = "surface/unlit.frag"}, 0);
}

} // namespace

void register_surface(App& app) {
    app.add_component<Surface>();
    World& world = app.world();
    if (!world.find_resource<MeshStore>()) world.set_resource(MeshStore{});
    world.set_resource(DrawList{});
    world.set_resource(DrawClaims{});
    std::vector<AovInfo>& aovs = frame_requests(world).known;
    aovs.push_back({"color", "the picture in linear RGB, before it is encoded; not clamped", {"R", "G", "B"}});
    aovs.push_back(
        {"normal",
         "unit surface normal in the world, with the normal map's relief, on the side that is seen; 0 where nothing is "
         "drawn",
         {"normal.X", "normal.Y", "normal.Z"}});
    aovs.push_back(
        {"object_id",
         "1 for the visible entity with a surface or a picture made first, and so on; 0 where nothing is drawn",
         {"object_id"}});
    app.add_system(Stage::material, "surface.collect", CollectSurfaces{});
    app.add_system(Stage::render, "surface.passes", declare_passes);
}

} // namespace hachure
