#include <hachure/systems/script/component_keys.h>

#include <lua5.4/lua.hpp>

namespace hachure::script {

void ComponentKeys::update(lua_State* state, const TypeRegistry& types) {
    while (components_.size() < types.types().size()) {
        const TypeInfo& type = types.types()[components_.size()];
        const int number = first_component + static_cast<int>(components_.size());
        ComponentKey& component = components_.emplace_back();
        component.type = &type;
        for (const FieldInfo& info : type.fields) {
            component.names.add(state, info.name, static_cast<int>(component.fields.size()));
            FieldKey& field = component.fields.emplace_back();
            field.info = &info;
            for (const std::string& option : info.options) {
                lua_pushlstring(state, option.data(), option.size());
                field.options.push_back(luaL_ref(state, LUA_REGISTRYINDEX));
            }
        }
        component_names_.add(state, type.name, number);
        lua_pushlstring(state, type.name.data(), type.name.size());
        if (names_.find(state, -1) == KeyMap::none) names_.add(state, type.name, number);
        lua_pop(state, 1);
    }
}

const ComponentKey* ComponentKeys::find_component(lua_State* state, int index) const {
    const int number = component_names_.find(state, index);
    return number == KeyMap::none ? nullptr : &component(number);
}

} // namespace hachure::script
