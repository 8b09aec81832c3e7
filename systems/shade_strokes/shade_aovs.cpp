#include <hachure/runtime/scene/draw_list.h>
#include <hachure/runtime/scene/light_list.h>
#include <hachure/runtime/scene/mesh_store.h>
#include <hachure/runtime/scene/render_context.h>
#include <hachure/runtime/scene/view.h>
#include <hachure/systems/shade_strokes/shade_aovs.h>
#include <hachure/systems/shade_strokes/shade_frame.h>

#include <array>

namespace hachure {
namespace {

constexpr const char* needed_name = "shade_needed";
constexpr const char* delivered_name = "shade_delivered";
constexpr const char* coverage_name = "stroke_coverage";
constexpr const char* coverage_source = "shade_coverage"; // the texture of those who draw strokes

constexpr std::array no_shade_value{0.0f, 0.0f, 0.0f, 0.0f};

struct CellPass {
    gpu::TextureHandle depth_buffer, shade;
};

struct BarePass {
    gpu::TextureHandle coverage;
};

/// In a buffer that is as large as it has to be.
template <class T> void fill_buffer(gpu::Buffer& buffer, std::span<const T> values, const char* label) {
    if (buffer.bytes() < values.size_bytes())
        buffer = gpu::Buffer(values, label, gpu::BufferUsage::dynamic);
    else
        buffer.update(values);
}

} // namespace

void know_shade_aovs(FrameRequests& requests) {
    requests.known.push_back(
        {needed_name,
         "shade that the light on a surface's cell calls for, 0 to 1; 0 where no strokes are asked "
         "for",
         {needed_name}});
    requests.known.push_back({delivered_name,
                              "shade that the strokes in a surface's cell stand for: at most the dead band away from "
                              "shade_needed where they can; 0 where there are none",
                              {delivered_name}});
    requests.known.push_back(
        {coverage_name, "how much of a pixel shade strokes cover, times their strength, 0 to 1", {coverage_name}});
}

void request_shade_sources(FrameRequests& requests) {
    if (requests.aovs.contains(coverage_name)) requests.textures.emplace(coverage_source);
}

void ShadeAovs::declare(World& world) {
    const FrameRequests& requests = world.resource<FrameRequests>();
    if (requests.wants(needed_name)) declare_cells(world, needed_name, Value::needed);
    if (requests.wants(delivered_name)) declare_cells(world, delivered_name, Value::delivered);
    if (requests.wants(coverage_name)) declare_coverage(world);
}

void ShadeAovs::declare_cells(World& world, const char* name, Value value) {
    RenderContext& render = world.resource_mutable<RenderContext>();
    const View& view = world.resource<View>();
    render.graph.add_pass<CellPass>(
        name,
        [&](gpu::PassBuilder& pass, CellPass& data) {
            data.depth_buffer = pass.read(render.graph.find("depth_buffer"));
            data.shade = pass.create(name, {view.width, view.height, gpu::Format::r32f});
            render.graph.publish(name, data.shade);
            const std::uint64_t values =
                value == Value::needed ? world.resource<ShadeNeeds>().key : world.resource<ShadeFrame>().key;
            pass.depends_on(world.resource<DrawList>().key, values, render.shaders->generation());
        },
        [this, &world, &render, value](const CellPass& data, gpu::PassContext& pass) {
            const gpu::Framebuffer& target = render.backend->framebuffer({pass.texture(data.shade)});
            target.bind();
            gpu::apply({.viewport = {0, 0, target.width(), target.height()}});
            target.clear_color(0, no_shade_value);
            render.view_uniforms.bind(world.resource<View>(), world.resource<LightList>());
            render.backend->texture(pass.texture(data.depth_buffer)).bind(0);
            const std::size_t surfaces = world.resource<ShadeFrame>().surfaces.size();
            buffers_[static_cast<std::size_t>(value)].resize(surfaces);
            for (std::size_t i = 0; i < surfaces; ++i) draw(world, i, value);
        });
}

/// Those who draw strokes make no texture where there are none.
void ShadeAovs::declare_coverage(World& world) {
    RenderContext& render = world.resource_mutable<RenderContext>();
    if (const gpu::TextureHandle coverage = render.graph.find(coverage_source)) {
        render.graph.publish(coverage_name, coverage);
        return;
    }
    const View& view = world.resource<View>();
    render.graph.add_pass<BarePass>(
        "no_stroke_coverage",
        [&](gpu::PassBuilder& pass, BarePass& data) {
            data.coverage = pass.create(coverage_name, {view.width, view.height, gpu::Format::r32f});
            render.graph.publish(coverage_name, data.coverage);
            pass.depends_on(view.width, view.height);
        },
        [&render](const BarePass& data, gpu::PassContext& pass) {
            const gpu::Framebuffer& target = render.backend->framebuffer({pass.texture(data.coverage)});
            gpu::apply({.viewport = {0, 0, target.width(), target.height()}});
            target.clear_color(0, no_shade_value);
        });
}

void ShadeAovs::upload(World& world, std::size_t surface, Value value) {
    const ShadeSurface& shaded = world.resource<ShadeFrame>().surfaces[surface];
    const ShadeNeeds::Surface& needs = world.resource<ShadeNeeds>().surfaces[surface];
    const DrawItem& item = world.resource<DrawList>().items[shaded.item];
    const std::vector<std::uint32_t>& indices = world.resource<MeshStore>().mesh(item.mesh).indices;
    corner_scratch_.clear();
    for (const std::uint32_t vertex : indices) corner_scratch_.push_back(needs.positions[vertex]);
    triangle_scratch_.clear();
    const ShadeCells& cells = shaded.mesh->cells;
    for (const std::uint32_t triangle : shaded.mesh->sheets.triangle_of)
        triangle_scratch_.push_back(triangle == geometry::SurfaceSheets::none
                                        ? glm::uvec2(0)
                                        : glm::uvec2(cells.first_atom[triangle], cells.parts[triangle]));
    shade_scratch_.assign(needs.needed.begin(), needs.needed.end());
    if (value == Value::delivered)
        for (std::size_t c = 0; c < shade_scratch_.size(); ++c) shade_scratch_[c] = shaded.chains->cells[c].delivered;
    Buffers& to = buffers(surface, value);
    fill_buffer(to.corners, std::span<const glm::vec3>(corner_scratch_), "shade corners");
    fill_buffer(to.triangles, std::span<const glm::uvec2>(triangle_scratch_), "shade triangles");
    fill_buffer(to.cells, std::span<const std::uint32_t>(cells.cell_of_atom), "shade cells");
    fill_buffer(to.shade, std::span<const float>(shade_scratch_), "shade of cells");
    to.vertex_array = gpu::VertexArray("shade corners");
    to.vertex_array.set_attribute({.location = 0, .components = 3});
    to.vertex_array.set_vertex_buffer(0, to.corners, sizeof(glm::vec3));
}

void ShadeAovs::draw(World& world, std::size_t surface, Value value) {
    const ShadeSurface& shaded = world.resource<ShadeFrame>().surfaces[surface];
    if (shaded.mesh->cell_count() == 0) return;
    upload(world, surface, value);
    const Buffers& from = buffers(surface, value);
    from.triangles.bind_base(gpu::BufferBinding::storage, 0);
    from.cells.bind_base(gpu::BufferBinding::storage, 1);
    from.shade.bind_base(gpu::BufferBinding::storage, 2);
    RenderContext& render = world.resource_mutable<RenderContext>();
    gpu::Program& program = render.shaders->program(
        {.vertex = "shade_strokes/cell_shade.vert", .fragment = "shade_strokes/cell_shade.frag"});
    program.set("world_from_entity", shaded.world_from_mesh);
    program.use();
    from.vertex_array.bind();
    gpu::gl().DrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(corner_scratch_.size()));
}

} // namespace hachure
