#include <hachure/runtime/ecs/type_id.h>

#include <atomic>

namespace hachure::detail {

TypeId next_type_id(TypeFamily family) {
    static std::atomic<TypeId> components = 0;
    static std::atomic<TypeId> resources = 0;
    return (family == TypeFamily::component ? components : resources)++;
}

} // namespace hachure::detail
