#pragma once

#include <hachure/runtime/geometry/bounds.h>
#include <hachure/runtime/geometry/surface_segment.h>
#include <hachure/runtime/scene/draw_list.h>
#include <hachure/runtime/scene/mesh_store.h>

#include <cstdint>
#include <map>
#include <span>
#include <utility>
#include <vector>

namespace hachure {

/// An item whose lines are drawn.
struct CrossingItem {
    const DrawItem* item = nullptr;
    bool wants_intersections = false;
};

/// Where surfaces pass through each other, two by two; kept while neither changes its shape nor they move against each
/// other. The line belongs to the first of the two that wants intersections, and is in its space.
class Crossings {
public:
    /// Finds the lines between all items of which one wants them at least, and forgets those of other pairs.
    void update(std::span<const CrossingItem> items, const MeshStore& store);

    /// The lines that belong to an item, one list per surface that it crosses; valid until the next update.
    [[nodiscard]] std::vector<std::span<const geometry::SurfaceSegment>> of(Entity entity) const;

    /// Another number when these lines are others.
    [[nodiscard]] std::uint64_t key(Entity entity) const;

private:
    struct Pair {
        std::uint64_t key = 0; ///< of shapes and places
        bool used = false;     ///< in this frame
        std::vector<geometry::SurfaceSegment> segments;
    };
    std::map<std::pair<Entity, Entity>, Pair> pairs_; ///< owner, other
    std::vector<geometry::Bounds> bounds_;            ///< scratch: of the items, in the world
};

} // namespace hachure
