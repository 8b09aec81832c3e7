#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <typeinfo>

namespace hachure::detail {

/// A small number for a type, from 1 on; it differs between runs and is never stored. The same type has the same number
/// in a program and in every shared library that it loads.
using TypeId = std::uint32_t;

/// Each family is counted apart, so that tables indexed by numbers stay small: components, resources, sets of
/// components that entities are created with, and queries.
enum class TypeFamily { component, resource, bundle, query };

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

/// Several types as one.
template <class... T> struct TypeList {};

/// [[gnu::const]]: it gives the same number ever after, so that a call on a path that is hardly ever taken does not
/// make compilers read again what they have read.
template <TypeFamily family, class T> [[gnu::const, gnu::noinline]] TypeId make_type_id() {
    // The name is looked up once per shared library; hidden visibility gives each a variable of its own.
    static const TypeId id = next_type_id(family, {typeid(T).name(), sizeof(T), alignof(T)});
    return id;
}

/// Set before `main` or while a library is loaded; 0, which is no type's number, until then.
template <TypeFamily family, class T> inline const TypeId type_id_of = make_type_id<family, T>();

template <TypeFamily family, class T> inline TypeId type_id() {
    // A plain load, which compilers can keep in a register, unlike the guarded variable of a function.
    const TypeId id = type_id_of<family, T>;
    return id != 0 ? id : make_type_id<family, T>();
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

/// The same, found while compiling.
template <class T> inline constexpr std::string_view type_name_of = type_name<T>();

} // namespace hachure::detail
