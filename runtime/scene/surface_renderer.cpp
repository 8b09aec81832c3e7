#include <hachure/runtime/assets/texcoord_transform.h>
#include <hachure/runtime/gpu/state.h>
#include <hachure/runtime/scene/light_list.h>
#include <hachure/runtime/scene/mesh_store.h>
#include <hachure/runtime/scene/render_context.h>
#include <hachure/runtime/scene/surface_renderer.h>
#include <hachure/runtime/scene/view.h>

#include <optional>

namespace hachure {
namespace {

const gpu::Framebuffer& bind_targets(RenderContext& render, gpu::PassContext& pass, const SurfaceTargets& targets) {
    const auto id = [&](gpu::TextureHandle handle) { return handle ? pass.texture(handle) : 0u; };
    const std::uint32_t depth = pass.texture(targets.depth_buffer);
    const gpu::Framebuffer& framebuffer =
        targets.normal || targets.object_id || targets.code
            ? render.backend->framebuffer(
                  {pass.texture(targets.color), id(targets.normal), id(targets.object_id), id(targets.code)}, depth)
            : render.backend->framebuffer({pass.texture(targets.color)}, depth);
    framebuffer.bind();
    return framebuffer;
}

bool has_normal_map(const SurfaceMesh& mesh, const SurfaceMaterial& material) {
    return material.normal_texture >= 0 && !mesh.tangents.empty() &&
           !(mesh.texcoords.empty() && mesh.normal_texcoords.empty());
}

void material_defines(const SurfaceMesh& mesh, const SurfaceMaterial& material,
                      std::vector<gpu::ShaderDefine>& defines) {
    if (material.base_color_texture >= 0 && !mesh.texcoords.empty()) defines.push_back({"BASE_COLOR_TEXTURE", ""});
    if (!mesh.colors.empty()) defines.push_back({"VERTEX_COLOR", ""});
    if (has_normal_map(mesh, material)) {
        defines.push_back({"NORMAL_MAP", ""});
        if (!mesh.normal_texcoords.empty()) defines.push_back({"NORMAL_TEXCOORD", ""});
    }
    if (material.alpha_cutoff > 0.0f) defines.push_back({"ALPHA_MASK", ""});
    if (material.double_sided) defines.push_back({"DOUBLE_SIDED", ""});
}

/// Sets the rows of the affine map of (u, v, 1).
void set_transform(gpu::Program& program, const char* u, const char* v, const glm::mat3x2& transform) {
    program.set(u, glm::vec3(transform[0].x, transform[1].x, transform[2].x));
    program.set(v, glm::vec3(transform[0].y, transform[1].y, transform[2].y));
}

void set_material(gpu::Program& program, const DrawItem& item, const SurfaceMaterial& material) {
    program.set("base_color", glm::vec4(item.tint, 1.0f) * material.base_color);
    program.set("alpha_cutoff", material.alpha_cutoff);
    set_transform(program, "texcoord_u", "texcoord_v",
                  assets::texcoord_transform(material.uv_offset, material.uv_scale, material.uv_rotation));
    if (material.normal_texture < 0) return;
    program.set("normal_scale", material.normal_scale);
    set_transform(
        program, "normal_texcoord_u", "normal_texcoord_v",
        assets::texcoord_transform(material.normal_uv_offset, material.normal_uv_scale, material.normal_uv_rotation));
}

void set_item(gpu::Program& program, const DrawItem& item) {
    program.set("world_from_entity", item.world_from_entity);
    program.set("world_from_normal", item.world_from_normal);
    program.set("object_id", item.object_id);
}

/// What holds for all items of a pass.
struct ItemPass {
    gpu::Rect viewport;
    std::optional<gpu::Rect> scissor = {};
    bool normal = false, object_id = false, code = false; ///< what the shaders write besides their colour
};

gpu::DrawState draw_state(const ItemPass& pass, const DrawItem& item, const SurfaceMaterial& material) {
    gpu::DrawState state;
    state.viewport = pass.viewport;
    state.scissor = pass.scissor;
    state.depth_test = gpu::DepthTest::greater;
    state.depth_write = true;
    state.srgb_write = true;
    if (!material.double_sided) state.cull = item.mirrored ? gpu::Cull::front : gpu::Cull::back;
    return state;
}

void draw_item(const World& world, RenderContext& render, const DrawItem& item, const ItemPass& pass,
               const SurfaceShading& shading) {
    const MeshStore& store = world.resource<MeshStore>();
    const SurfaceMesh& mesh = store.mesh(item.mesh);
    const gpu::VertexArray* own = shading.vertex_array ? shading.vertex_array(item) : nullptr;
    (own ? *own : render.meshes.vertex_array(store, item)).bind();
    for (const Submesh& submesh : mesh.submeshes) {
        if (submesh.index_count == 0) continue;
        gpu::ProgramSource source{.vertex = std::string(shading.vertex), .fragment = std::string(shading.fragment)};
        if (pass.normal) source.defines.push_back({"OUT_NORMAL", ""});
        if (pass.object_id) source.defines.push_back({"OUT_OBJECT_ID", ""});
        if (pass.code) source.defines.push_back({"OUT_CODE", ""});
        if (item.mirrored) source.defines.push_back({"MIRRORED", ""});
        material_defines(mesh, submesh.material, source.defines);
        if (shading.defines) shading.defines(item.entity, source.defines);
        gpu::Program& program = render.shaders->program(source);
        set_item(program, item);
        set_material(program, item, submesh.material);
        if (shading.uniforms) shading.uniforms(item.entity, program);
        if (submesh.material.base_color_texture >= 0 && !mesh.texcoords.empty())
            render.meshes.texture(store, submesh.material.base_color_texture).bind(0);
        if (has_normal_map(mesh, submesh.material))
            render.meshes.texture(store, submesh.material.normal_texture).bind(1);
        if (shading.bind) shading.bind(item);
        gpu::apply(draw_state(pass, item, submesh.material));
        program.use();
        gpu::gl().DrawElements(GL_TRIANGLES, static_cast<GLsizei>(submesh.index_count), GL_UNSIGNED_INT,
                               reinterpret_cast<const void*>(std::size_t{submesh.first_index} * sizeof(std::uint32_t)));
    }
}

} // namespace

SurfaceTargets SurfaceTargets::write(gpu::FrameGraph& graph, gpu::PassBuilder& pass) {
    const auto write_named = [&](std::string_view name) {
        gpu::TextureHandle handle = graph.find(name);
        if (handle) {
            handle = pass.write(handle);
            graph.publish(name, handle);
        }
        return handle;
    };
    return {write_named("color"), write_named("depth_buffer"), write_named("normal"), write_named("object_id"),
            write_named("surface_code")};
}

void draw_surfaces(const World& world, RenderContext& render, gpu::PassContext& pass, const SurfaceTargets& targets,
                   const SurfaceShading& shading) {
    bind_targets(render, pass, targets);
    render.view_uniforms.bind(world.resource<View>(), world.resource<LightList>());
    const View& view = world.resource<View>();
    const ItemPass items{
        {0, 0, view.width, view.height}, {}, bool(targets.normal), bool(targets.object_id), bool(targets.code)};
    const DrawList& list = world.resource<DrawList>();
    const DrawClaims& claims = world.resource<DrawClaims>();
    for (std::size_t i = 0; i < list.items.size(); ++i)
        if (claims.shading[i] == shading.name) draw_item(world, render, list.items[i], items, shading);
}

void draw_all_surfaces(const World& world, RenderContext& render, std::string_view fragment,
                       const gpu::Rect& viewport) {
    draw_all_surfaces(world, render, {.fragment = fragment}, viewport, viewport);
}

void draw_all_surfaces(const World& world, RenderContext& render, const SurfaceShading& shading,
                       const gpu::Rect& viewport, const gpu::Rect& scissor) {
    render.view_uniforms.bind(world.resource<View>(), world.resource<LightList>());
    for (const DrawItem& item : world.resource<DrawList>().items)
        draw_item(world, render, item, {viewport, scissor}, shading);
}

void add_surface_pass(World& world, const SurfaceShading& shading, std::uint64_t key) {
    const DrawList& list = world.resource<DrawList>();
    const DrawClaims& claims = world.resource<DrawClaims>();
    if (!claims.any(shading.name)) return;
    RenderContext& render = world.resource_mutable<RenderContext>();
    // Who shades an item can change while the list, lights and shading stay as they are.
    gpu::KeyHash claimed;
    for (std::size_t i = 0; i < list.items.size(); ++i)
        if (claims.shading[i] == shading.name) claimed.add(list.items[i].object_id);
    const std::uint64_t light_key = world.resource<LightList>().key();
    render.graph.add_pass<SurfaceTargets>(
        shading.name,
        [&](gpu::PassBuilder& pass, SurfaceTargets& targets) {
            targets = SurfaceTargets::write(render.graph, pass);
            pass.depends_on(list.key, claimed.value(), light_key, key, render.shaders->generation());
        },
        [&world, &render, shading](const SurfaceTargets& targets, gpu::PassContext& pass) {
            draw_surfaces(world, render, pass, targets, shading);
        });
}

} // namespace hachure
