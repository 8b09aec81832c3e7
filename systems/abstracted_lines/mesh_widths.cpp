#include <hachure/runtime/app/log.h>
#include <hachure/runtime/geometry/edge_lengths.h>
#include <hachure/runtime/geometry/weld.h>
#include <hachure/systems/abstracted_lines/mesh_widths.h>

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

namespace hachure {

std::vector<float> painted_widths(const SurfaceMesh& mesh, PaintChannel channel) {
    std::vector<float> result;
    for (const glm::vec4& color : mesh.colors)
        result.push_back(std::clamp(color[static_cast<int>(channel)], 0.0f, 1.0f));
    return result;
}

std::vector<float> edge_length_widths(const SurfaceMesh& mesh) {
    const std::vector<std::uint32_t> weld = geometry::weld_positions(mesh.positions);
    std::vector<float> result(mesh.positions.size());
    geometry::EdgeLengthsJob job{
        .positions = mesh.positions, .indices = mesh.indices, .weld = weld, .relative = result};
    job.run();
    return result;
}

const VertexWidths* MeshWidths::find(const MeshStore& store, std::uint32_t mesh, const AbstractedLines& lines) {
    const bool by_paint = lines.width_by == LineAbstraction::paint;
    if (!by_paint && lines.width_by != LineAbstraction::edge_length) return nullptr;
    const auto [entry, fresh] =
        widths_.try_emplace({mesh, lines.width_by, by_paint ? lines.paint_channel : PaintChannel::alpha});
    VertexWidths& widths = entry->second;
    if (fresh) {
        const SurfaceMesh& surface = store.mesh(mesh);
        const std::vector<float> factors =
            by_paint ? painted_widths(surface, lines.paint_channel) : edge_length_widths(surface);
        for (const float factor : factors) widths.factors.emplace_back(factor, 0.0f, 0.0f);
        widths.version = ++version_;
        if (by_paint && factors.empty() && warned_.insert(mesh).second)
            log_warning(fmt::format("abstracted_lines: the mesh '{}' has no vertex colours that lines could be "
                                    "painted with: they have their full width",
                                    surface.name));
    }
    return widths.factors.empty() ? nullptr : &widths;
}

} // namespace hachure
