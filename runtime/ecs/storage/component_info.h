#pragma once

#include <hachure/runtime/ecs/entity_map.h>
#include <hachure/runtime/ecs/storage.h>
#include <hachure/runtime/ecs/type_id.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <new>
#include <string_view>
#include <type_traits>
#include <utility>

namespace hachure::detail {

/// What storage needs to know of a component type in order to keep values of it without knowing the type.
struct ComponentInfo {
    TypeId id;
    std::uint32_t stride; ///< bytes; 0 for empty types
    std::uint32_t alignment;
    Storage storage;
    bool trivial; ///< moved by copying its bytes, destroyed by forgetting it
    std::string_view name;
    void (*relocate)(void* to, void* from); ///< constructs at `to` from `from`, and destroys `from`
    void (*destroy)(void* value);
    void (*copy)(void* to, const void* from);            ///< constructs at `to`; null where C cannot be copied
    void (*remap)(void* value, const EntityMap& copies); ///< see EntityMap; null where C offers no remap_entities
};

/// Components are aligned to at most a cache line, as the columns are.
inline constexpr std::uint32_t max_alignment = 64;

template <class C> const ComponentInfo& component_info() {
    static_assert(alignof(C) <= max_alignment, "components are aligned to at most 64 bytes");
    static_assert(sizeof(C) <= (1u << 20), "a component of more than a megabyte keeps its data elsewhere");
    using Copy = void (*)(void*, const void*);
    constexpr Copy copy = [] {
        if constexpr (std::is_copy_constructible_v<C>)
            return Copy([](void* to, const void* from) { new (to) C(*static_cast<const C*>(from)); });
        else
            return Copy(nullptr);
    }();
    using Remap = void (*)(void*, const EntityMap&);
    constexpr Remap remap = [] {
        if constexpr (requires(C & value, const EntityMap& copies) { remap_entities(value, copies); })
            return Remap([](void* value, const EntityMap& copies) { remap_entities(*static_cast<C*>(value), copies); });
        else
            return Remap(nullptr);
    }();
    static const ComponentInfo info{.id = component_id<C>(),
                                    .stride = stride_of<C>,
                                    .alignment = alignof(C),
                                    .storage = storage_of<C>,
                                    .trivial = std::is_trivially_copyable_v<C>,
                                    .name = type_name<C>(),
                                    .relocate =
                                        [](void* to, void* from) {
                                            new (to) C(std::move(*static_cast<C*>(from)));
                                            std::destroy_at(static_cast<C*>(from));
                                        },
                                    .destroy = [](void* value) { std::destroy_at(static_cast<C*>(value)); },
                                    .copy = copy,
                                    .remap = remap};
    return info;
}

/// Where value number `i` of a column is.
template <class C> C* step(C* column, std::uint32_t i) { return std::is_empty_v<C> ? column : column + i; }

/// Memory for one value that is not constructed yet.
template <class C> class Raw {
public:
    C* place() { return reinterpret_cast<C*>(bytes_); }

private:
    alignas(C) std::byte bytes_[sizeof(C)];
};

/// Copies the few bytes of a component; the sizes that components mostly have don't pay for a call.
inline void copy_bytes(std::byte* to, const std::byte* from, std::uint32_t size) {
    if (size >= 8 && size <= 16) {
        std::uint64_t head, tail;
        std::memcpy(&head, from, 8);
        std::memcpy(&tail, from + size - 8, 8);
        std::memcpy(to, &head, 8);
        std::memcpy(to + size - 8, &tail, 8);
    } else if (size == 4) {
        std::memcpy(to, from, 4);
    } else if (size > 16 && size <= 32) {
        std::byte head[16], tail[16];
        std::memcpy(head, from, 16);
        std::memcpy(tail, from + size - 16, 16);
        std::memcpy(to, head, 16);
        std::memcpy(to + size - 16, tail, 16);
    } else {
        std::memcpy(to, from, size);
    }
}

} // namespace hachure::detail
