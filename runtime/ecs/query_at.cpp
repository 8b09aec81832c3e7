#include <hachure/runtime/ecs/query_at.h>

namespace hachure::detail {
namespace {

// An explicit instantiation may name a private member. This file goes when worlds offer what it reaches for.
template <auto source> struct Parts {
    friend QuerySource parts_of(const World& world) { return (world.*source)(); }
};
QuerySource parts_of(const World& world);
template struct Parts<&World::source>;

} // namespace

QuerySource query_parts(const World& world) { return parts_of(world); }

} // namespace hachure::detail
