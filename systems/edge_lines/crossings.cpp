#include <hachure/runtime/geometry/intersect_meshes.h>
#include <hachure/runtime/gpu/frame_graph_key.h>
#include <hachure/systems/edge_lines/crossings.h>

#include <glm/matrix.hpp>
#include <glm/vector_relational.hpp>

namespace hachure {
namespace {

std::span<const glm::vec3> positions_of(const DrawItem& item, const MeshStore& store) {
    const bool deformed = item.shape.version != 0 && !item.shape.on_gpu;
    return deformed ? item.shape.positions : std::span(store.mesh(item.mesh).positions);
}

geometry::Bounds bounds_of(const DrawItem& item, const MeshStore& store) {
    const bool deformed = item.shape.version != 0 && !item.shape.on_gpu;
    const geometry::Bounds own = deformed ? geometry::bounds_of(item.shape.positions) : store.mesh(item.mesh).bounds;
    return transformed(own, item.world_from_entity);
}

bool touch(const geometry::Bounds& a, const geometry::Bounds& b) {
    return !a.empty() && !b.empty() && glm::all(glm::lessThanEqual(a.low, b.high)) &&
           glm::all(glm::lessThanEqual(b.low, a.high));
}

} // namespace

void Crossings::update(std::span<const CrossingItem> items, const MeshStore& store) {
    for (auto& [entities, pair] : pairs_) pair.used = false;
    bounds_.clear();
    for (const CrossingItem& item : items) bounds_.push_back(bounds_of(*item.item, store));
    for (std::size_t i = 0; i < items.size(); ++i)
        for (std::size_t j = i + 1; j < items.size(); ++j) {
            if (!items[i].wants_intersections && !items[j].wants_intersections) continue;
            if (!touch(bounds_[i], bounds_[j])) continue;
            const DrawItem& owner = *items[items[i].wants_intersections ? i : j].item;
            const DrawItem& other = *items[items[i].wants_intersections ? j : i].item;
            const glm::mat4 owner_from_other = glm::inverse(owner.world_from_entity) * other.world_from_entity;
            Pair& pair = pairs_[{owner.entity, other.entity}];
            pair.used = true;
            const std::uint64_t key =
                gpu::key_of(owner.mesh, owner.shape.version, other.mesh, other.shape.version, owner_from_other);
            if (pair.key == key) continue;
            pair.key = key;
            pair.segments = geometry::mesh_intersections(positions_of(owner, store), store.mesh(owner.mesh).indices,
                                                         positions_of(other, store), store.mesh(other.mesh).indices,
                                                         owner_from_other);
        }
    std::erase_if(pairs_, [](const auto& entry) { return !entry.second.used; });
}

std::vector<std::span<const geometry::SurfaceSegment>> Crossings::of(Entity entity) const {
    std::vector<std::span<const geometry::SurfaceSegment>> lists;
    for (const auto& [entities, pair] : pairs_)
        if (entities.first == entity && !pair.segments.empty()) lists.emplace_back(pair.segments);
    return lists;
}

std::uint64_t Crossings::key(Entity entity) const {
    gpu::KeyHash hash;
    for (const auto& [entities, pair] : pairs_)
        if (entities.first == entity) hash.add(pair.key);
    return hash.value();
}

} // namespace hachure
