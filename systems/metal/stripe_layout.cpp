#include <hachure/runtime/assets/stripe_cache.h>
#include <hachure/runtime/geometry/weld.h>
#include <hachure/runtime/gpu/frame_graph_key.h>
#include <hachure/systems/metal/stripe_layout.h>

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <utility>
#include <vector>

namespace hachure {
namespace {

using geometry::StripeMesh;

/// The mesh as it is, its coordinate still 0.
StripeMesh uncut(const SurfaceMesh& mesh) {
    const std::size_t count = mesh.positions.size();
    StripeMesh stripes;
    stripes.source_vertex.resize(count);
    std::iota(stripes.source_vertex.begin(), stripes.source_vertex.end(), 0u);
    stripes.indices = mesh.indices;
    stripes.coordinate.assign(count, 0.0f);
    stripes.weight.assign(count, 1.0f);
    return stripes;
}

StripeMesh by_texture(const SurfaceMesh& mesh, const Metal& metal, int component) {
    StripeMesh stripes = uncut(mesh);
    for (std::size_t v = 0; v < stripes.coordinate.size(); ++v) {
        const float u = metal.sets * mesh.texcoords[v][component];
        stripes.coordinate[v] = std::isfinite(u) ? std::clamp(u, -1e5f, 1e5f) : 0.0f;
    }
    return stripes;
}

StripeMesh along_axis(const SurfaceMesh& mesh, const Metal& metal) {
    StripeMesh stripes = uncut(mesh);
    const StripeAxis axis = stripe_axis(mesh, metal);
    float low = std::numeric_limits<float>::max(), high = std::numeric_limits<float>::lowest();
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
        stripes.coordinate[v] = (axis.axis_from_entity * (mesh.positions[v] - axis.point)).z;
        low = std::min(low, stripes.coordinate[v]);
        high = std::max(high, stripes.coordinate[v]);
    }
    const float scale = high > low ? metal.sets / (high - low) : 0.0f;
    for (float& u : stripes.coordinate) u = (u - low) * scale;
    return stripes;
}

/// Repeats vertices of `stripes` where triangles disagree on their coordinate.
class Cutter {
public:
    explicit Cutter(StripeMesh& stripes) : stripes_(stripes), taken_(stripes.coordinate.size(), false) {}

    /// The vertex with that coordinate that lies on vertex `source` of the mesh.
    std::uint32_t vertex(std::uint32_t source, float u) {
        if (!taken_[source]) {
            taken_[source] = true;
            stripes_.coordinate[source] = u;
        }
        if (stripes_.coordinate[source] == u) return source;
        const auto [found, is_new] =
            repeated_.try_emplace({source, u}, static_cast<std::uint32_t>(stripes_.coordinate.size()));
        if (is_new) {
            stripes_.source_vertex.push_back(source);
            stripes_.coordinate.push_back(u);
            stripes_.weight.push_back(1.0f);
        }
        return found->second;
    }

    /// Which vertices are one point of a smooth surface, for the frames.
    void join(const SurfaceMesh& mesh) {
        const std::vector<std::uint32_t> weld = geometry::weld_normals(mesh.positions, mesh.normals);
        for (const std::uint32_t source : stripes_.source_vertex) stripes_.stands_for.push_back(weld[source]);
        stripes_.mirrored.assign(stripes_.coordinate.size(), 0);
    }

private:
    StripeMesh& stripes_;
    std::vector<bool> taken_;
    std::map<std::pair<std::uint32_t, float>, std::uint32_t> repeated_;
};

/// The angle as a coordinate of vertices, which is cut where it begins anew; for surfaces that deform, whose fragments
/// no longer tell it by their place.
StripeMesh around_axis(const SurfaceMesh& mesh, const Metal& metal) {
    StripeMesh stripes = uncut(mesh);
    const StripeAxis axis = stripe_axis(mesh, metal);
    const float sets = sets_around(metal), nowhere = 1e-6f * mesh.bounds.radius();
    Cutter cutter(stripes);
    for (std::size_t first = 0; first + 2 < mesh.indices.size(); first += 3) {
        std::array<float, 3> turns{};
        std::array<bool, 3> on_axis{};
        float reference = 0.0f, sum = 0.0f, known = 0.0f;
        for (std::size_t c = 0; c < 3; ++c) {
            const glm::vec3 p = axis.axis_from_entity * (mesh.positions[mesh.indices[first + c]] - axis.point);
            on_axis[c] = std::hypot(p.x, p.y) <= nowhere;
            if (on_axis[c]) continue;
            turns[c] = std::atan2(p.y, p.x) / glm::two_pi<float>();
            if (known == 0.0f) reference = turns[c];
            turns[c] -= std::round(turns[c] - reference);
            sum += turns[c];
            known += 1.0f;
        }
        for (std::size_t c = 0; c < 3; ++c) {
            if (on_axis[c]) turns[c] = known > 0.0f ? sum / known : 0.0f; // a point of the axis lies at every angle
            stripes.indices[first + c] = cutter.vertex(mesh.indices[first + c], sets * turns[c]);
        }
    }
    cutter.join(mesh);
    return stripes;
}

StripeMesh by_curvature(const SurfaceMesh& mesh, const Metal& metal) {
    const geometry::StripeSettings settings{
        .sets = double{metal.sets}, .detail = double{metal.detail}, .crease_angle = double{metal.crease_angle}};
    return assets::cached_stripe_mesh(mesh.positions, mesh.normals, mesh.indices, settings,
                                      assets::user_cache_folder());
}

} // namespace

MetalSource stripe_source(const SurfaceMesh& mesh, const Metal& metal) {
    const bool by_texture = metal.source == MetalSource::texture_u || metal.source == MetalSource::texture_v;
    return by_texture && mesh.texcoords.size() != mesh.positions.size() ? MetalSource::curvature : metal.source;
}

std::uint64_t stripe_layout_key(std::uint32_t mesh_index, const SurfaceMesh& mesh, const Metal& metal) {
    gpu::KeyHash key;
    const MetalSource source = stripe_source(mesh, metal);
    key.add(mesh_index);
    key.add(source);
    key.add(metal.sets);
    if (source == MetalSource::curvature) {
        key.add(metal.detail);
        key.add(metal.crease_angle);
    }
    if (source == MetalSource::around_axis || source == MetalSource::along_axis) {
        key.add(metal.axis);
        key.add(metal.axis_offset);
    }
    return key.value();
}

StripeMesh lay_stripes(const SurfaceMesh& mesh, const Metal& metal) {
    switch (stripe_source(mesh, metal)) {
    case MetalSource::texture_u:
        return by_texture(mesh, metal, 0);
    case MetalSource::texture_v:
        return by_texture(mesh, metal, 1);
    case MetalSource::around_axis:
        return around_axis(mesh, metal);
    case MetalSource::along_axis:
        return along_axis(mesh, metal);
    case MetalSource::curvature:
        break;
    }
    return by_curvature(mesh, metal);
}

StripeAxis stripe_axis(const SurfaceMesh& mesh, const Metal& metal) {
    const float length = glm::length(metal.axis);
    const glm::vec3 z = length > 1e-20f ? metal.axis / length : glm::vec3(0.0f, 1.0f, 0.0f);
    // The start of the angles: the coordinate axis that is most across it.
    const glm::vec3 across = std::abs(z.x) <= std::min(std::abs(z.y), std::abs(z.z)) ? glm::vec3(1.0f, 0.0f, 0.0f)
                             : std::abs(z.z) <= std::abs(z.y)                        ? glm::vec3(0.0f, 0.0f, 1.0f)
                                                                                     : glm::vec3(0.0f, 1.0f, 0.0f);
    const glm::vec3 x = glm::normalize(across - glm::dot(across, z) * z), y = glm::cross(z, x);
    return {mesh.bounds.center() + metal.axis_offset, glm::transpose(glm::mat3(x, y, z))};
}

float sets_around(const Metal& metal) { return std::max(1.0f, std::round(metal.sets)); }

} // namespace hachure
