// Components and their fields, as scripts see them.

#include <hachure/runtime/error.h>
#include <hachure/systems/script/lua_entity.h>
#include <hachure/systems/script/lua_fields.h>
#include <hachure/systems/script/script_context.h>

#include <lua5.4/lua.hpp>

namespace hachure::script {
namespace {

/// The component itself, to read; raises an error when it is gone.
const void* component_of(lua_State* state, ComponentBox& box) {
    const Context& context = context_of(state);
    if (box.structure == context.structure) return box.component;
    const World& world = *context.world;
    if (const void* const component = box.key->type->find(world, box.entity)) {
        box.structure = context.structure;
        return box.component = component;
    }
    luaL_error(state, world.alive(box.entity) ? "the entity has no %s any more" : "the entity of this %s is not alive",
               box.key->type->name.c_str());
    return nullptr;
}

const FieldKey& check_field(lua_State* state, const ComponentKey& key, int index) {
    const int found = key.names.find(state, index);
    if (found == KeyMap::none)
        luaL_error(state, "%s has no field %s", key.type->name.c_str(), luaL_tolstring(state, index, nullptr));
    return key.fields[static_cast<std::size_t>(found)];
}

int get_field(lua_State* state) {
    auto& box = *static_cast<ComponentBox*>(lua_touserdata(state, 1));
    const void* const component = component_of(state, box);
    push_field(state, check_field(state, *box.key, 2), component);
    return 1;
}

/// Only what differs is written, since writing marks the component changed.
void assign(World& world, const ComponentBox& box, const FieldInfo& field, const Given& given) {
    const FieldValue value = value_for(field, given);
    const TypeInfo& type = *box.key->type;
    if (field.get(type.find(world, box.entity)) == value) return;
    field.set(type.find_mutable(world, box.entity), value);
}

int set_field(lua_State* state) {
    auto& box = *static_cast<ComponentBox*>(lua_touserdata(state, 1));
    component_of(state, box);
    assign(*context_of(state).world, box, *check_field(state, *box.key, 2).info, given_at(state, 3));
    return 0;
}

int component_text(lua_State* state) {
    const auto* const box = static_cast<const ComponentBox*>(box_at(state, 1, BoxKind::component));
    lua_pushstring(state, box ? box->key->type->name.c_str() : "component");
    return 1;
}

/// Raises an error when the table at `index` has keys that are no fields.
void check_keys(lua_State* state, int index, const ComponentKey& key) {
    for (lua_pushnil(state); lua_next(state, index); lua_pop(state, 1)) check_field(state, key, -2);
}

/// Checks all values before anything is done. The table is at stack index 3.
void collect_values(lua_State* state, const ComponentKey& key) {
    Context& context = context_of(state);
    context.values.assign(key.fields.size(), FieldValue());
    for (std::size_t i = 0; i < key.fields.size(); ++i) {
        const FieldInfo& info = *key.fields[i].info;
        context.values[i] = info.default_value;
        lua_pushlstring(state, info.name.data(), info.name.size());
        if (lua_rawget(state, 3) != LUA_TNIL) context.values[i] = value_for(info, given_at(state, -1));
        lua_pop(state, 1);
    }
}

} // namespace

int add_component(lua_State* state) {
    Context& context = context_of(state);
    const Entity entity = check_alive(state, 1);
    const ComponentKey& key = check_component(state, 2);
    const TypeInfo& type = *key.type;
    lua_settop(state, 3);
    if (lua_type(state, 3) != LUA_TNIL) {
        luaL_checktype(state, 3, LUA_TTABLE);
        check_keys(state, 3, key);
    } else {
        lua_newtable(state);
        lua_replace(state, 3);
    }
    context.machine->charge(state, steps_of_a_structural_change);
    collect_values(state, key);
    // One that is there already keeps the fields that are not named.
    const bool is_new = type.find(*context.world, entity) == nullptr;
    ++context.structure;
    if (is_new) type.add_default(*context.world, entity);
    for (std::size_t i = 0; i < key.fields.size(); ++i) {
        const FieldInfo& info = *key.fields[i].info;
        lua_pushlstring(state, info.name.data(), info.name.size());
        const bool named = lua_rawget(state, 3) != LUA_TNIL;
        lua_pop(state, 1);
        if (named && !(info.get(type.find(*context.world, entity)) == context.values[i]))
            info.set(type.find_mutable(*context.world, entity), context.values[i]);
    }
    push_component(state, 1, key);
    return 1;
}

void push_component(lua_State* state, int index, const ComponentKey& key) {
    auto& entity = *static_cast<EntityBox*>(lua_touserdata(state, index));
    for (int i = 0; i < kept_components; ++i)
        if (entity.kept[i] == &key) {
            lua_getiuservalue(state, index, i + 1);
            return;
        }
    auto* const box = static_cast<ComponentBox*>(lua_newuserdatauv(state, sizeof(ComponentBox), 0));
    *box = {BoxKind::component, entity.entity, &key, nullptr, 0};
    lua_rawgeti(state, LUA_REGISTRYINDEX, context_of(state).component_methods);
    lua_setmetatable(state, -2);
    lua_pushvalue(state, -1);
    lua_setiuservalue(state, index, entity.next + 1);
    entity.kept[entity.next] = &key;
    entity.next = (entity.next + 1) % kept_components;
}

const ComponentKey& check_component(lua_State* state, int index) {
    luaL_checktype(state, index, LUA_TSTRING);
    const ComponentKey* const key = context_of(state).keys.find_component(state, index);
    if (!key) luaL_error(state, "there is no component %s", lua_tostring(state, index));
    return *key;
}

void open_components(lua_State* state) {
    static constexpr NamedFunction functions[] = {{"__index", bound<get_field>},
                                                  {"__newindex", bound<set_field>},
                                                  {"__tostring", component_text},
                                                  {nullptr, nullptr}};
    push_metatable(state, "component", functions);
    context_of(state).component_methods = luaL_ref(state, LUA_REGISTRYINDEX);
}

} // namespace hachure::script
