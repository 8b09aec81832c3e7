#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <typeinfo>

namespace hachure::detail {

/// A small number for a type, handed out in order of first use; it differs between runs and is never stored. The same
/// type has the same number in a program and in every shared library that it loads.
using TypeId = std::uint32_t;

/// The numbers of component types and of resource types are counted apart, so that tables indexed by them stay small.
enum class TypeFamily { component, resource };

/// What a translation unit knows of a type: the name that linkers know it by, and its layout.
struct TypeKey {
    std::string_view mangled; ///< std::type_info::name(), which compilers of one ABI agree on
    std::size_t size;
    std::size_t alignment;
};

/// The number of a type by its name: a new one the first time, the same one ever after. Types that belong to one file
/// (of an anonymous namespace, local to a function) get a new number each time, because another file may have another
/// type of that name. Asserts when one name comes with two layouts: two libraries were built from different sources.
/// May be called by several threads.
TypeId next_type_id(TypeFamily family, const TypeKey& key);

template <TypeFamily family, class T> TypeId type_id() {
    // The name is looked up once per shared library; hidden visibility gives each a variable of its own.
    static const TypeId id = next_type_id(family, {typeid(T).name(), sizeof(T), alignof(T)});
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
