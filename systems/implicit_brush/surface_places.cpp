#include <hachure/components/deformed.h>
#include <hachure/runtime/scene/light_list.h>
#include <hachure/runtime/scene/mesh_store.h>
#include <hachure/runtime/scene/render_context.h>
#include <hachure/runtime/scene/view.h>
#include <hachure/systems/implicit_brush/surface_places.h>

#include <glm/matrix.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace hachure {
namespace {

constexpr float least_scale = 1e-30f;

float scale_of(const glm::mat3& matrix) { return std::cbrt(std::abs(glm::determinant(matrix))); }

/// The middle one of the joints' scales; the palette's last entry is none of a joint.
float skin_scale(const std::vector<geometry::JointMatrix>& palette) {
    if (palette.size() < 2) return 1.0f;
    std::vector<float> scales;
    for (std::size_t j = 0; j + 1 < palette.size(); ++j) {
        const auto& row = palette[j].row;
        scales.push_back(scale_of(glm::mat3(glm::vec3(row[0]), glm::vec3(row[1]), glm::vec3(row[2]))));
    }
    const auto middle = scales.begin() + static_cast<std::ptrdiff_t>(scales.size() / 2);
    std::ranges::nth_element(scales, middle);
    return *middle;
}

} // namespace

float rest_scale(const World& world, const DrawItem& item) {
    const Deformed* deformed = item.shape.version == 0 ? nullptr : world.find<Deformed>(item.entity);
    const float scale = scale_of(glm::mat3(item.world_from_entity)) * (deformed ? skin_scale(deformed->palette) : 1.0f);
    return std::max(scale, least_scale);
}

void SurfacePlaces::draw_item(const World& world, RenderContext& render, const DrawItem& item) {
    const MeshStore& store = world.resource<MeshStore>();
    const SurfaceMesh& mesh = store.mesh(item.mesh);
    if (mesh.indices.empty()) return;
    gpu::ProgramSource source{.vertex = "implicit_brush/place.vert", .fragment = "implicit_brush/place.frag"};
    const bool deformed = item.shape.version != 0;
    if (deformed) {
        source.defines.push_back({"DEFORMED", ""});
        rest_positions_.get(item.entity, item.mesh, mesh.positions).bind(1);
    }
    const float radius = std::max(mesh.bounds.radius(), std::numeric_limits<float>::min());
    gpu::Program& program = render.shaders->program(source);
    program.set("world_from_entity", item.world_from_entity);
    program.set("rest_middle", mesh.bounds.center());
    program.set("rest_radius", radius);
    program.set("radius_metres", std::max(radius * rest_scale(world, item), least_scale));
    program.set("object_seed", static_cast<std::uint32_t>(gpu::key_of(item.entity.index)));
    program.use();
    render.meshes.vertex_array(store, item).bind();
    gpu::gl().DrawElements(GL_TRIANGLES, static_cast<GLsizei>(mesh.indices.size()), GL_UNSIGNED_INT, nullptr);
}

void SurfacePlaces::draw(const World& world, RenderContext& render, const PlaceTextures& textures,
                         const gpu::Rect& rect) {
    const std::vector<DrawItem>& items = world.resource<DrawList>().items;
    std::vector<Entity> deformed;
    for (const DrawItem& item : items)
        if (item.shape.version != 0) deformed.push_back(item.entity);
    rest_positions_.forget_all_but(deformed);
    const gpu::Framebuffer& framebuffer = render.backend->framebuffer({textures.places, textures.objects});
    framebuffer.bind();
    gpu::apply({.viewport = {0, 0, framebuffer.width(), framebuffer.height()}, .scissor = rect});
    framebuffer.clear_color(0, std::array{0.0f, 0.0f, 0.0f, 0.0f});
    framebuffer.clear_color(1, std::array{0u, 0u, 0u, 0u});
    render.view_uniforms.bind(world.resource<View>(), world.resource<LightList>());
    render.backend->texture(textures.depth_buffer).bind(0);
    for (const DrawItem& item : items) draw_item(world, render, item);
}

} // namespace hachure
