#pragma once

#include <hachure/runtime/ecs/type_id.h>

#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace hachure::detail {

/// One value per type. A resource stays where it is until it is replaced or removed.
class Resources {
public:
    template <class T> T& set(T&& value) {
        static_assert(!std::is_reference_v<T>, "T is named by the caller, so this is an rvalue");
        const TypeId id = resource_id<T>();
        if (id >= slots_.size()) slots_.resize(id + 1);
        auto owned = std::make_unique<Holder<T>>(std::forward<T>(value));
        T& result = owned->value;
        slots_[id] = std::move(owned);
        return result;
    }

    template <class T> T* find() const {
        const TypeId id = resource_id<T>();
        return id < slots_.size() && slots_[id] ? &static_cast<Holder<T>&>(*slots_[id]).value : nullptr;
    }

    template <class T> bool remove() {
        if (!find<T>()) return false;
        slots_[resource_id<T>()].reset();
        return true;
    }

private:
    struct Base {
        virtual ~Base() = default;
    };
    template <class T> struct Holder final : Base {
        explicit Holder(T&& from) : value(std::move(from)) {}
        T value;
    };
    std::vector<std::unique_ptr<Base>> slots_;
};

} // namespace hachure::detail
