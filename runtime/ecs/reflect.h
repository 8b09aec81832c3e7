#pragma once

#include <hachure/runtime/assert.h>
#include <hachure/runtime/ecs/field_info.h>
#include <hachure/runtime/ecs/field_text.h>
#include <hachure/runtime/ecs/type_hash.h>
#include <hachure/runtime/ecs/world.h>

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace hachure {

// What TypeInfo calls back; `context` is the caller's own.
using ComponentVisit = void (*)(void* context, Entity entity, const void* component);
using ComponentFill = void (*)(void* context, std::size_t first, std::size_t count, void* components);

/// A reflected component type: how users see it, and access to it in a world without knowing the type. Pointers to
/// components hold until the next structural change, and give `FieldInfo::get` and `set` what they work on.
struct TypeInfo {
    std::string name; ///< lower case with underscores; its own among the types of a registry
    std::string doc;  ///< one line
    std::vector<FieldInfo> fields;
    std::uint64_t id = 0; ///< type_hash(name): the same in every build; its own among the types of a registry
    std::size_t size = 0; ///< of a component, in bytes

    /// Null when there is no such field.
    const FieldInfo* field(std::string_view field_name) const;

    // As the members of World of these names.
    const void* (*find)(const World& world, Entity entity) = nullptr;
    void* (*find_mutable)(World& world, Entity entity) = nullptr;
    bool (*remove)(World& world, Entity entity) = nullptr;

    /// As World::add with a default-constructed component.
    void* (*add_default)(World& world, Entity entity) = nullptr;

    /// Every entity that has the component.
    std::vector<Entity> (*entities)(const World& world) = nullptr;

    // For many components at once.

    /// Calls `visit(context, entity, component)` for every entity that has the component.
    void (*each)(const World& world, ComponentVisit visit, void* context) = nullptr;

    /// As World::add for each of `entities`, in order. Components are made in blocks: `fill(context, first, count,
    /// components)` gives `count` default-constructed ones, `size` bytes apart, their values before they move to
    /// `entities[first]` and those that follow it.
    void (*add_many)(World& world, std::span<const Entity> entities, ComponentFill fill, void* context) = nullptr;

    detail::TypeId component = 0; ///< tells types apart within one process
};

/// Describes the field that `TypeBuilder::field` added last.
class FieldBuilder {
public:
    explicit FieldBuilder(FieldInfo& field) : field_(&field) {}

    /// One line for users.
    FieldBuilder& doc(std::string_view text);
    /// "m", "rad", "s", "px", ...
    FieldBuilder& unit(std::string_view text);
    /// The values allowed, both ends included; for integers, reals, and each element of vectors.
    FieldBuilder& range(double min, double max);
    /// Says that a vec3 or vec4 is a colour in linear light.
    FieldBuilder& color();
    /// The names of an enumeration's values; they are 0, 1, 2, ... in this order. Every enumeration needs them.
    FieldBuilder& options(std::initializer_list<std::string_view> names);

private:
    FieldInfo* field_;
};

/// What a component says about itself, in a function beside it:
///
///     inline void reflect(TypeBuilder<Gooch>& type) {
///         type.name("gooch").doc("Warm to cool shading.");
///         type.field("b", &Gooch::b).doc("strength of the blue").range(0, 1);
///     }
///
/// Fields are bool, 32 and 64 bit integers, float, double, glm::vec2, vec3, vec4 and quat, std::string, Entity, and
/// enumerations.
template <Component C> class TypeBuilder {
public:
    /// `defaults` is a default-constructed component.
    TypeBuilder(TypeInfo& type, const C& defaults) : type_(&type), defaults_(&defaults) {}

    TypeBuilder& name(std::string_view text) {
        type_->name = text;
        return *this;
    }

    TypeBuilder& doc(std::string_view text) {
        type_->doc = text;
        return *this;
    }

    template <class M> FieldBuilder field(std::string_view name, M C::*member) {
        using Carrier = typename detail::Carrier<M>::type;
        FieldInfo& field = type_->fields.emplace_back();
        field.name = name;
        field.kind = detail::field_kind<M>();
        field.bits = detail::field_bits<M>();
        field.offset = static_cast<std::size_t>(reinterpret_cast<const std::byte*>(&(defaults_->*member)) -
                                                reinterpret_cast<const std::byte*>(defaults_));
        field.size = sizeof(M);
        field.read = [member](const void* component) {
            return FieldValue(static_cast<Carrier>(static_cast<const C*>(component)->*member));
        };
        field.write = [member](void* component, const FieldValue& value) {
            static_cast<C*>(component)->*member = static_cast<M>(std::get<Carrier>(value));
        };
        return FieldBuilder(field);
    }

private:
    TypeInfo* type_;
    const C* defaults_;
};

namespace detail {

template <Component C>
void add_many(World& world, std::span<const Entity> entities, ComponentFill fill, void* context) {
    // Small enough for the cache, large enough to forget the price of the call.
    constexpr std::size_t block = std::max<std::size_t>(1, 16384 / sizeof(C));
    std::vector<C> components;
    for (std::size_t first = 0; first < entities.size(); first += block) {
        const std::size_t count = std::min(block, entities.size() - first);
        components.clear();
        components.resize(count);
        fill(context, first, count, components.data());
        for (std::size_t i = 0; i < count; ++i) world.add<C>(entities[first + i], std::move(components[i]));
    }
}

} // namespace detail

/// The reflected component types of a program.
class TypeRegistry {
public:
    /// Registers C by its `reflect` function, found beside C. Does nothing when C is registered already. A missing or
    /// doubled name, an enumeration without options, or a default outside its range is our own mistake and asserts.
    template <Component C>
    requires std::default_initializable<C>
    const TypeInfo& add();

    /// Null when there is no such type.
    const TypeInfo* find(std::string_view name) const;

    /// In order of registration. Entries stay where they are.
    const std::deque<TypeInfo>& types() const { return types_; }

private:
    const TypeInfo* find(detail::TypeId component) const;

    /// Completes and checks a type, with a default-constructed component.
    const TypeInfo& insert(TypeInfo type, const void* defaults);

    std::deque<TypeInfo> types_;
};

template <Component C>
requires std::default_initializable<C>
const TypeInfo& TypeRegistry::add() {
    if (const TypeInfo* known = find(detail::component_id<C>())) return *known;
    TypeInfo type;
    const C defaults{};
    TypeBuilder<C> builder(type, defaults);
    reflect(builder);
    type.size = sizeof(C);
    type.component = detail::component_id<C>();
    type.find = [](const World& world, Entity entity) -> const void* { return world.find<C>(entity); };
    type.find_mutable = [](World& world, Entity entity) -> void* { return world.find_mutable<C>(entity); };
    type.remove = [](World& world, Entity entity) { return world.remove<C>(entity); };
    type.add_default = [](World& world, Entity entity) -> void* { return &world.add<C>(entity, C{}); };
    type.entities = [](const World& world) {
        std::vector<Entity> result;
        world.query<With<C>>().each([&result](Entity entity) { result.push_back(entity); });
        return result;
    };
    type.each = [](const World& world, ComponentVisit visit, void* context) {
        world.query<const C>().each([&](Entity entity, const C& component) { visit(context, entity, &component); });
    };
    type.add_many = &detail::add_many<C>;
    return insert(std::move(type), &defaults);
}

} // namespace hachure
