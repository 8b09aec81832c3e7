#include <hachure/runtime/assert.h>
#include <hachure/runtime/geometry/direction_field.h>
#include <hachure/runtime/geometry/sheet_curvature.h>
#include <hachure/runtime/geometry/sheet_metric.h>
#include <hachure/runtime/geometry/sheet_normals.h>
#include <hachure/runtime/geometry/sparse_system.h>
#include <hachure/runtime/geometry/stripe_frames.h>
#include <hachure/runtime/geometry/stripe_mesh.h>
#include <hachure/runtime/geometry/stripe_phase.h>
#include <hachure/runtime/geometry/stripe_rate.h>
#include <hachure/runtime/geometry/stripe_readings.h>
#include <hachure/runtime/geometry/surface_sheets.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <tuple>

namespace hachure::geometry {
namespace {

constexpr double most_sets = 1e5;

/// Gives every corner of the input a vertex with its coordinate, repeating vertices where corners differ.
class Assembly {
public:
    Assembly(std::span<const glm::vec3> positions, std::span<const std::uint32_t> indices, const SurfaceSheets& sheets,
             const SheetMetric& metric, const StripePhase& phase, const StripeReadings& readings)
        : positions_(positions), indices_(indices), sheets_(sheets), metric_(metric), phase_(phase),
          readings_(readings), taken_(positions.size(), 0) {
        const std::size_t vertices = positions.size();
        mesh_.source_vertex.resize(vertices);
        std::iota(mesh_.source_vertex.begin(), mesh_.source_vertex.end(), 0u);
        mesh_.stands_for = mesh_.source_vertex;
        mesh_.coordinate.resize(vertices);
        mesh_.weight.resize(vertices);
        mesh_.mirrored.resize(vertices);
        sheet_vertices_.assign(vertices, SurfaceSheets::none);
        find_weights();
    }

    StripeMesh run() {
        mesh_.indices.resize(indices_.size());
        for (std::uint32_t f = 0; f < sheets_.triangle_of.size(); ++f) {
            const std::uint32_t t = sheets_.triangle_of[f];
            for (std::size_t k = 0; k < 3; ++k) {
                const std::uint32_t source = indices_[3 * f + k];
                mesh_.indices[3 * f + k] = t == SurfaceSheets::none ? source : vertex_of(source, corner_at(f, k, t));
            }
        }
        return std::move(mesh_);
    }

    /// Per vertex of the result: the vertex of the sheets that it is, or `none` at tips and where there is no sheet.
    [[nodiscard]] const std::vector<std::uint32_t>& sheet_vertices() const { return sheet_vertices_; }

private:
    /// Fades the pattern at the corners of singular triangles.
    void find_weights() {
        weights_.assign(sheets_.positions.size(), 1.0f);
        for (std::uint32_t t = 0; t < sheets_.triangles.size(); ++t)
            if (phase_.whole[t] == 0)
                for (const std::uint32_t v : sheets_.triangles[t]) weights_[v] = 0.0f;
    }

    /// The corner of triangle t that lies where corner k of the input's triangle f does.
    [[nodiscard]] std::uint32_t corner_at(std::uint32_t f, std::size_t k, std::uint32_t t) const {
        if (sheets_.face[t] == f) return static_cast<std::uint32_t>(3 * t + k);
        const glm::dvec3 place(positions_[indices_[3 * f + k]]); // a repeated triangle, perhaps turned
        for (std::uint32_t c = 0; c < 3; ++c)
            if (sheets_.positions[sheets_.triangles[t][c]] == place) return 3 * t + c;
        return static_cast<std::uint32_t>(3 * t + k);
    }

    [[nodiscard]] double coordinate_at(std::uint32_t corner) const {
        return readings_[corner].of(phase_.value[sheets_.tail(corner)]);
    }

    std::uint32_t vertex_of(std::uint32_t source, std::uint32_t corner) {
        const std::uint32_t own = sheets_.tail(corner);
        const bool tip = metric_.tip[own] != 0;
        const StripeReading reading = tip ? StripeReading{} : readings_[corner];
        const Key key{source, own, reading.sign, reading.jump, tip ? corner / 3 : 0};
        const auto [found, is_new] = known_.try_emplace(key, source);
        if (!is_new) return found->second;
        if (taken_[source] != 0) {
            found->second = static_cast<std::uint32_t>(mesh_.source_vertex.size());
            mesh_.source_vertex.push_back(source);
            mesh_.stands_for.push_back(found->second);
            mesh_.coordinate.push_back(0.0f);
            mesh_.weight.push_back(0.0f);
            mesh_.mirrored.push_back(0);
            sheet_vertices_.push_back(SurfaceSheets::none);
        }
        taken_[source] = 1;
        fill(found->second, corner, tip, reading.sign);
        return found->second;
    }

    void fill(std::uint32_t vertex, std::uint32_t corner, bool tip, std::int8_t sign) {
        const std::uint32_t own = sheets_.tail(corner);
        const double u =
            tip ? 0.5 * (coordinate_at(SurfaceSheets::next(corner)) + coordinate_at(SurfaceSheets::previous(corner)))
                : coordinate_at(corner);
        const bool sound = std::abs(u) <= most_sets;
        mesh_.coordinate[vertex] = sound ? static_cast<float>(u) : 0.0f;
        mesh_.weight[vertex] = sound ? weights_[own] : 0.0f;
        if (tip) return;
        sheet_vertices_[vertex] = own;
        const auto [first, is_new] = standing_.try_emplace(own, Standing{vertex, sign});
        mesh_.stands_for[vertex] = first->second.vertex;
        mesh_.mirrored[vertex] = first->second.sign != sign ? 1 : 0;
    }

    using Key = std::tuple<std::uint32_t, std::uint32_t, std::int8_t, double, std::uint32_t>;
    struct Standing {
        std::uint32_t vertex;
        std::int8_t sign;
    };

    std::span<const glm::vec3> positions_;
    std::span<const std::uint32_t> indices_;
    const SurfaceSheets& sheets_;
    const SheetMetric& metric_;
    const StripePhase& phase_;
    const StripeReadings& readings_;
    StripeMesh mesh_;
    std::vector<std::uint32_t> sheet_vertices_;
    std::vector<std::uint8_t> taken_; ///< per vertex of the input: its place in the result is used
    std::vector<float> weights_;      ///< per vertex of the sheets
    std::map<Key, std::uint32_t> known_;
    std::map<std::uint32_t, Standing> standing_;
};

/// `StripeMesh::lean` for these normals: `drawn` per vertex of the input or none, the others per vertex of the sheets.
std::vector<glm::vec3> lean_of(const StripeMesh& mesh, std::span<const glm::vec3> positions,
                               std::span<const glm::vec3> drawn, const std::vector<std::uint32_t>& sheet_vertices,
                               const std::vector<glm::dvec3>& bumpy, const std::vector<glm::dvec3>& smooth) {
    const std::size_t count = mesh.source_vertex.size();
    std::vector<glm::vec3> places(count), normals(count), lean(count, glm::vec3(0.0f, 0.0f, 1.0f));
    for (std::size_t v = 0; v < count; ++v) {
        const std::uint32_t source = mesh.source_vertex[v], own = sheet_vertices[v];
        places[v] = positions[source];
        normals[v] = !drawn.empty()               ? drawn[source]
                     : own != SurfaceSheets::none ? glm::vec3(bumpy[own])
                                                  : glm::vec3(0.0f, 1.0f, 0.0f);
    }
    std::vector<glm::vec4> frames(count);
    StripeFramesJob{.positions = places,
                    .normals = normals,
                    .indices = mesh.indices,
                    .coordinate = mesh.coordinate,
                    .stands_for = mesh.stands_for,
                    .mirrored = mesh.mirrored,
                    .frames = frames}
        .run();
    for (std::size_t v = 0; v < count; ++v) {
        if (sheet_vertices[v] == SurfaceSheets::none) continue;
        const glm::dvec3 n(normals[v]), x(glm::vec3(frames[v])), y = glm::cross(n, x);
        const glm::dvec3& wanted = smooth[sheet_vertices[v]];
        const glm::dvec3 own(glm::dot(wanted, x), glm::dot(wanted, y), glm::dot(wanted, n));
        const double length = glm::length(own);
        if (length > 1e-3 && std::isfinite(length)) lean[v] = glm::vec3(own / length);
    }
    return lean;
}

} // namespace

StripeMesh make_stripe_mesh(std::span<const glm::vec3> positions, std::span<const glm::vec3> normals,
                            std::span<const std::uint32_t> indices, const StripeSettings& settings) {
    HACHURE_ASSERT(normals.empty() || normals.size() == positions.size(), "one normal per vertex, or none");
    HACHURE_ASSERT(settings.sets > 0.0 && settings.detail > 0.0, "lengths are positive");
    const SurfaceSheets sheets = cut_into_sheets(positions, normals, indices, settings.crease_angle);
    const SheetMetric metric(sheets);
    const std::vector<std::uint32_t> order = elimination_order(sheets.positions.size(), sheet_edges(sheets));
    const SheetCurvature curvature = sheet_curvature(sheets, metric, order, settings.detail);
    const DirectionField field = direction_field(sheets, metric, curvature, order, settings.detail);
    const std::vector<double> rates = stripe_rates(sheets, metric, curvature, field, order, settings.sets);
    const std::vector<double> confidence = direction_confidences(metric, curvature);
    StripePhase phase = stripe_phase(sheets, metric, field, rates, order);
    fit_phase(sheets, metric, field, rates, confidence, order, phase);
    settle_phase(sheets, metric, field, rates, phase);
    const StripeReadings readings(sheets, metric, phase);
    Assembly assembly(positions, indices, sheets, metric, phase, readings);
    StripeMesh mesh = assembly.run();
    const std::vector<glm::dvec3> bumpy = sheet_normals(sheets, metric, normals, indices);
    const std::vector<glm::dvec3> smooth =
        smooth_sheet_normals(sheets, metric, curvature, bumpy, order, settings.detail);
    const std::vector<double> clarity = stripe_clarity(sheets, metric, field, rates, phase);
    for (std::size_t v = 0; v < mesh.weight.size(); ++v) {
        const std::uint32_t own = assembly.sheet_vertices()[v];
        mesh.clarity.push_back(own == SurfaceSheets::none ? mesh.weight[v] : static_cast<float>(clarity[own]));
    }
    mesh.lean = lean_of(mesh, positions, normals, assembly.sheet_vertices(), bumpy, smooth);
    return mesh;
}

} // namespace hachure::geometry
