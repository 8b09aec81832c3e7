#pragma once

#include <cstdint>
#include <string_view>

namespace hachure::detail {

/// A small number for a type, handed out in order of first use; it differs between runs and is never stored.
using TypeId = std::uint32_t;

/// The numbers of component types and of resource types are counted apart, so that tables indexed by them stay small.
enum class TypeFamily { component, resource, bundle, query };

TypeId next_type_id(TypeFamily family);

template <TypeFamily family, class T> TypeId type_id() {
    static const TypeId id = next_type_id(family);
    return id;
}

template <class C> TypeId component_id() { return type_id<TypeFamily::component, C>(); }
template <class T> TypeId resource_id() { return type_id<TypeFamily::resource, T>(); }

/// The name of T as the compiler spells it, for messages.
template <class T> constexpr std::string_view type_name() {
    // "... type_name() [with T = X; std::string_view = ...]" (GCC), "... type_name() [T = X]" (Clang).
    const std::string_view text = __PRETTY_FUNCTION__;
    const std::size_t begin = text.find("T = ") + 4;
    const std::size_t semicolon = text.find(';', begin);
    return text.substr(begin, (semicolon == text.npos ? text.rfind(']') : semicolon) - begin);
}

} // namespace hachure::detail
