#include <hachure/editor/model_report.h>
#include <hachure/runtime/geometry/bounds.h>
#include <hachure/runtime/geometry/mesh_health.h>
#include <hachure/systems/model/posed_vertices.h>

#include <fmt/format.h>

#include <algorithm>

namespace hachure {
namespace {

using assets::Model;

std::string joined(const std::vector<std::string>& texts) {
    std::string result;
    for (const std::string& text : texts) result += (result.empty() ? "" : ", ") + text;
    return result.empty() ? "none" : result;
}

/// A mesh's primitives as one surface: what is connected across materials counts as connected.
geometry::MeshHealth mesh_health(const assets::Mesh& mesh) {
    std::vector<glm::vec3> positions;
    std::vector<std::uint32_t> indices;
    for (const assets::Primitive& primitive : mesh.primitives) {
        const auto first = static_cast<std::uint32_t>(positions.size());
        positions.insert(positions.end(), primitive.positions.begin(), primitive.positions.end());
        for (const std::uint32_t index : primitive.indices) indices.push_back(first + index);
    }
    return geometry::inspect(positions, indices);
}

geometry::MeshHealth total_health(const Model& model) {
    geometry::MeshHealth total;
    for (const assets::Mesh& mesh : model.meshes) {
        const geometry::MeshHealth h = mesh_health(mesh);
        total.triangles += h.triangles;
        total.vertices += h.vertices;
        total.isolated_vertices += h.isolated_vertices;
        total.degenerate_triangles += h.degenerate_triangles;
        total.sliver_triangles += h.sliver_triangles;
        total.duplicate_triangles += h.duplicate_triangles;
        total.boundary_edges += h.boundary_edges;
        total.holes += h.holes;
        total.non_manifold_edges += h.non_manifold_edges;
        total.non_manifold_vertices += h.non_manifold_vertices;
        total.mismatched_edges += h.mismatched_edges;
        total.components += h.components;
        total.flipped_triangles += h.flipped_triangles;
        total.non_orientable_pieces += h.non_orientable_pieces;
        total.inside_out_pieces += h.inside_out_pieces;
    }
    return total;
}

geometry::Bounds rest_bounds(const Model& model) {
    geometry::Bounds bounds;
    const std::vector<glm::mat4> matrices = node_matrices(model.nodes);
    for (std::size_t i = 0; i < model.nodes.size(); ++i) {
        const assets::Node& node = model.nodes[i];
        if (node.mesh < 0) continue;
        for (const std::vector<glm::vec3>& positions : posed_vertices(model, node, matrices))
            bounds.include(transformed(geometry::bounds_of(positions), node.skin >= 0 ? glm::mat4(1.0f) : matrices[i]));
    }
    return bounds;
}

std::string vector_text(glm::vec3 v) { return fmt::format("{:.6g} {:.6g} {:.6g}", v.x, v.y, v.z); }

std::size_t distinct_joints(const Model& model) {
    std::vector<std::int32_t> joints;
    for (const assets::Skin& skin : model.skins) joints.insert(joints.end(), skin.joints.begin(), skin.joints.end());
    std::ranges::sort(joints);
    return static_cast<std::size_t>(std::unique(joints.begin(), joints.end()) - joints.begin());
}

std::size_t morph_targets(const Model& model) {
    std::size_t count = 0;
    for (const assets::Mesh& mesh : model.meshes)
        if (!mesh.primitives.empty()) count += mesh.primitives.front().morph_targets.size();
    return count;
}

std::string clip_text(const Model& model) {
    if (model.animations.empty()) return "0";
    std::vector<std::string> names;
    float seconds = 0.0f;
    for (const assets::Animation& animation : model.animations) {
        names.push_back(
            fmt::format("{} ({:.3g} s)", animation.name.empty() ? "unnamed" : animation.name, animation.duration));
        seconds += animation.duration;
    }
    return fmt::format("{} ({:.4g} s): {}", model.animations.size(), seconds, joined(names));
}

std::string health_text(const geometry::MeshHealth& h) {
    if (h.triangles == 0) return "no triangle";
    std::vector<std::string> faults;
    const auto add = [&](std::uint32_t count, const char* what) {
        if (count > 0) faults.push_back(fmt::format("{} {}", count, what));
    };
    add(h.holes, h.holes == 1 ? "hole" : "holes");
    add(h.boundary_edges, "boundary edges");
    add(h.non_manifold_edges, "non-manifold edges");
    add(h.non_manifold_vertices, "non-manifold vertices");
    add(h.degenerate_triangles, "degenerate triangles");
    add(h.sliver_triangles, "triangles without area");
    add(h.duplicate_triangles, "duplicate triangles");
    add(h.mismatched_edges, "edges whose faces disagree on the front");
    add(h.flipped_triangles, "flipped triangles");
    add(h.inside_out_pieces, "inside-out pieces");
    add(h.non_orientable_pieces, "pieces without two sides");
    add(h.isolated_vertices, "isolated vertices");
    return faults.empty() ? "closed, oriented, manifold" : joined(faults);
}

} // namespace

std::vector<ReportRow> report_model(std::string_view file, const Model& model) {
    std::size_t primitives = 0, vertices = 0, computed = 0;
    for (const assets::Mesh& mesh : model.meshes)
        for (const assets::Primitive& primitive : mesh.primitives) {
            ++primitives;
            vertices += primitive.positions.size();
            computed += primitive.normals_computed ? 1 : 0;
        }
    const geometry::MeshHealth health = total_health(model);
    const geometry::Bounds bounds = rest_bounds(model);
    std::vector<ReportRow> rows{
        {"file", std::string(file)},
        {"kind", "model"},
        {"triangles", fmt::format("{}", health.triangles)},
        {"vertices", fmt::format("{} at {} places", vertices, health.vertices)},
        {"meshes", fmt::format("{} of {} primitives", model.meshes.size(), primitives)},
        {"nodes", fmt::format("{} in {} scenes", model.nodes.size(), model.scenes.size())},
        {"materials", fmt::format("{}, {} textures", model.materials.size(), model.textures.size())},
        {"cameras", fmt::format("{}", model.cameras.size())},
        {"lights", fmt::format("{}", model.lights.size())},
        {"skins", fmt::format("{}", model.skins.size())},
        {"joints", fmt::format("{}", distinct_joints(model))},
        {"clips", clip_text(model)},
        {"morph targets", fmt::format("{}", morph_targets(model))},
        {"extensions", joined(model.extensions)},
        {"bounds", bounds.empty() ? "empty" : vector_text(bounds.low) + " to " + vector_text(bounds.high)},
        {"components", fmt::format("{}", health.components)},
        {"normals",
         computed == 0 ? "from the file" : fmt::format("computed for {} of {} primitives", computed, primitives)},
        {"health", health_text(health)},
    };
    for (const std::string& warning : model.warnings) rows.push_back({"warning", warning});
    return rows;
}

} // namespace hachure
