#pragma once

#include <hachure/runtime/ecs/schedule/system_entry.h>
#include <hachure/runtime/parallel.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace hachure::detail {

/// The parts of a frame that systems are divided into before stages: frame systems of stage input, systems of fixed
/// step, other frame systems.
enum class FramePart { input, fixed, frame };

FramePart frame_part(const SystemEntry& system);

/// Systems in the order in which they run, or seem to run, with the explicit order among those of one part and stage.
struct LinearOrder {
    std::vector<SystemEntry*> systems;

    /// By place in `systems`: the places of those that say they run after it, or it before them; ascending.
    std::vector<std::vector<std::uint32_t>> followers;
};

/// By part, stage and registration, where the earliest registered system runs next of those whose predecessors all ran.
/// Asserts when the explicit order has a cycle or goes against the stages; names of unknown systems mean nothing.
LinearOrder linear_order(std::span<const std::unique_ptr<SystemEntry>> systems);

/// Whether two systems belong to the same part and stage.
bool same_place(const SystemEntry& a, const SystemEntry& b);

/// Neighbours in the linear order that may run at the same time, as far as `graph` lets them.
struct Batch {
    std::vector<SystemEntry*> systems;
    TaskGraph graph; ///< over `systems`: conflicting ones in their order, and explicit order
};

/// The batches of each FramePart, in order.
using Plan = std::array<std::vector<Batch>, 3>;

Plan make_plan(const LinearOrder& order);

} // namespace hachure::detail
