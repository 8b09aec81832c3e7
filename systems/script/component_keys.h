#pragma once

#include <hachure/runtime/ecs/reflect.h>
#include <hachure/systems/script/key_map.h>

#include <deque>
#include <vector>

struct lua_State;

namespace hachure::script {

/// A field as scripts reach it.
struct FieldKey {
    const FieldInfo* info = nullptr;
    std::vector<int> options; ///< of an enumeration: references of the names in Lua's registry
};

/// A component type as scripts reach it.
struct ComponentKey {
    const TypeInfo* type = nullptr;
    KeyMap names; ///< of fields, by place in `fields`
    std::vector<FieldKey> fields;
};

/// What can stand behind the dot of an entity, found by name: its own members and the reflected components.
class ComponentKeys {
public:
    /// Names of an entity's own members count from 0; components follow from here on.
    static constexpr int first_component = 100;

    /// Adds a member of entities with a number below `first_component`.
    void add_member(lua_State* state, const char* name, int number) { names_.add(state, name, number); }

    /// Takes in the types that were registered since.
    void update(lua_State* state, const TypeRegistry& types);

    /// The number of the member or component that the text at `index` names; KeyMap::none for others.
    [[nodiscard]] int find(lua_State* state, int index) const { return names_.find(state, index); }

    /// By a number from `first_component`. Stays where it is.
    [[nodiscard]] const ComponentKey& component(int number) const {
        return components_[static_cast<std::size_t>(number - first_component)];
    }

    /// The component that the text at `index` names, or null.
    [[nodiscard]] const ComponentKey* find_component(lua_State* state, int index) const;

private:
    KeyMap names_;
    KeyMap component_names_; ///< those that a member hides, too
    std::deque<ComponentKey> components_;
};

} // namespace hachure::script
