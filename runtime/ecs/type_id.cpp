#include <hachure/runtime/ecs/type_id.h>

#include <array>
#include <atomic>

namespace hachure::detail {

TypeId next_type_id(TypeFamily family) {
    static std::array<std::atomic<TypeId>, 4> counts{};
    return counts[static_cast<std::size_t>(family)]++;
}

} // namespace hachure::detail
