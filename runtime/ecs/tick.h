#pragma once

#include <cstdint>

namespace hachure {

/// The world's logical time. It starts at 1 and moves by one with `World::advance_tick`, which the schedule calls after
/// each system. A change carries the tick in which it was made.
///
/// Every "since" is exclusive: "changed since t" means with a tick greater than t. A system that keeps the tick in
/// which it ran and asks since that tick sees all that others did after it and nothing that it did itself; since 0
/// means ever.
using Tick = std::uint64_t;

} // namespace hachure
