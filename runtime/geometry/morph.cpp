#include <hachure/runtime/assert.h>
#include <hachure/runtime/geometry/morph.h>
#include <hachure/runtime/geometry/vertex_range.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace hachure::geometry {
namespace {

/// Vertices that are worked on at a time, so that they stay in the nearest cache while target after target is added.
constexpr std::size_t block_size = 1024;

MorphTargets::Array pack(std::span<const glm::vec3> deltas) {
    MorphTargets::Array array;
    const auto moves = [](const glm::vec3& delta) { return delta != glm::vec3(0.0f); };
    const auto moving = static_cast<std::size_t>(std::ranges::count_if(deltas, moves));
    const bool sparse = moving * (sizeof(glm::vec3) + sizeof(std::uint32_t)) < deltas.size() * sizeof(glm::vec3);
    if (!sparse) {
        array.deltas.assign(deltas.begin(), deltas.end());
        return array;
    }
    for (std::size_t v = 0; v < deltas.size(); ++v) {
        if (!moves(deltas[v])) continue;
        array.vertices.push_back(static_cast<std::uint32_t>(v));
        array.deltas.push_back(deltas[v]);
    }
    return array;
}

std::size_t bytes_of(const MorphTargets::Array& array) {
    return array.vertices.size() * sizeof(std::uint32_t) + array.deltas.size() * sizeof(glm::vec3);
}

glm::vec3 as_vec3(const glm::vec3& value) { return value; }
glm::vec3 as_vec3(const glm::vec4& value) { return glm::vec3(value); }
void add(glm::vec3& to, const glm::vec3& delta) { to += delta; }
void add(glm::vec4& to, const glm::vec3& delta) { to += glm::vec4(delta, 0.0f); }

/// out[v] += weight * delta[v] for the vertices [first, end).
template <class Value>
void add_array(const MorphTargets::Array& array, float weight, std::size_t first, std::size_t end,
               std::span<Value> out) {
    if (array.deltas.empty()) return;
    if (array.vertices.empty()) {
        for (std::size_t v = first; v < end; ++v) add(out[v], weight * array.deltas[v]);
        return;
    }
    const auto begin = std::ranges::lower_bound(array.vertices, first);
    for (auto i = static_cast<std::size_t>(begin - array.vertices.begin());
         i < array.vertices.size() && array.vertices[i] < end; ++i)
        add(out[array.vertices[i]], weight * array.deltas[i]);
}

/// What has weights that count is added to a copy of the base; says whether anything was.
template <class Value>
bool morph_values(const MorphJob& job, MorphTargets::Array MorphTargets::Target::*which, std::span<const Value> base,
                  std::span<Value> out, std::size_t first, std::size_t end) {
    std::copy(base.begin() + static_cast<std::ptrdiff_t>(first), base.begin() + static_cast<std::ptrdiff_t>(end),
              out.begin() + static_cast<std::ptrdiff_t>(first));
    bool added = false;
    for (std::size_t t = 0; t < job.targets->size(); ++t) {
        const MorphTargets::Array& array = (*job.targets)[t].*which;
        if (job.weights[t] == 0.0f || !std::isfinite(job.weights[t]) || array.deltas.empty()) continue;
        add_array(array, job.weights[t], first, end, out);
        added = true;
    }
    return added;
}

/// Makes xyz unit; the base's where nothing is left of it.
template <class Value> void normalise(std::span<const Value> base, std::span<Value> out, std::size_t v) {
    const glm::vec3 value = as_vec3(out[v]);
    const float square = glm::dot(value, value);
    const bool usable = square > 1e-12f && square < 1e30f; // not what rounding leaves of a sum that cancels
    const glm::vec3 unit = usable ? value / std::sqrt(square) : as_vec3(base[v]);
    for (int i = 0; i < 3; ++i) out[v][i] = unit[i];
}

void run_block(MorphJob& job, std::size_t first, std::size_t end) {
    morph_values(job, &MorphTargets::Target::positions, job.base_positions, job.positions, first, end);
    for (std::size_t v = first; v < end; ++v) job.bounds.include(job.positions[v]);
    if (!job.normals.empty() &&
        morph_values(job, &MorphTargets::Target::normals, job.base_normals, job.normals, first, end))
        for (std::size_t v = first; v < end; ++v) normalise(job.base_normals, job.normals, v);
    if (!job.tangents.empty() &&
        morph_values(job, &MorphTargets::Target::tangents, job.base_tangents, job.tangents, first, end))
        for (std::size_t v = first; v < end; ++v) normalise(job.base_tangents, job.tangents, v);
}

} // namespace

MorphTargets::MorphTargets(std::size_t vertex_count, std::span<const MorphDeltas> targets)
    : vertex_count_(vertex_count) {
    for (const MorphDeltas& target : targets) {
        for (const auto& deltas : {target.positions, target.normals, target.tangents})
            HACHURE_ASSERT(deltas.empty() || deltas.size() == vertex_count, "one displacement per vertex or none");
        targets_.push_back({pack(target.positions), pack(target.normals), pack(target.tangents)});
    }
}

std::size_t MorphTargets::bytes() const {
    std::size_t bytes = 0;
    for (const Target& target : targets_)
        bytes += bytes_of(target.positions) + bytes_of(target.normals) + bytes_of(target.tangents);
    return bytes;
}

void MorphJob::validate() const {
    const std::size_t count = base_positions.size();
    HACHURE_ASSERT(targets != nullptr && targets->vertex_count() == count, "targets of as many vertices");
    HACHURE_ASSERT(weights.size() == targets->size(), "one weight per target");
    HACHURE_ASSERT(positions.size() == count, "one position per vertex");
    HACHURE_ASSERT(normals.size() == base_normals.size() && (normals.empty() || normals.size() == count),
                   "one normal per vertex or none");
    HACHURE_ASSERT(tangents.size() == base_tangents.size() && (tangents.empty() || tangents.size() == count),
                   "one tangent per vertex or none");
}

void MorphJob::run() {
    bounds = {};
    const std::size_t end = end_of(range, base_positions.size());
    for (std::size_t first = range.first; first < end; first += block_size)
        run_block(*this, first, std::min(first + block_size, end));
}

void morph_in_parallel(MorphJob& job) { run_ranges_in_parallel(job, job.base_positions.size()); }

} // namespace hachure::geometry
