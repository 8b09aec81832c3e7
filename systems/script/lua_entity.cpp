#include <hachure/components/name.h>
#include <hachure/systems/script/lua_entity.h>
#include <hachure/systems/script/lua_fields.h>
#include <hachure/systems/script/script_context.h>

#include <lua5.4/lua.hpp>

#include <string>

namespace hachure::script {
namespace {

/// What stands behind the dot besides components; the numbers are keys of ComponentKeys.
enum Member { name, parent, children, first_method };

/// Before the structure changes.
void begin_change(lua_State* state) {
    context_of(state).machine->charge(state, steps_of_a_structural_change);
    ++context_of(state).structure;
}

int alive(lua_State* state) {
    const EntityBox* const box = entity_at(state, 1);
    if (!box) return luaL_argerror(state, 1, "an entity is needed");
    lua_pushboolean(state, context_of(state).world->alive(box->entity));
    return 1;
}

/// With all below it. One that is dead already is no error: two scripts may have the same idea.
int destroy(lua_State* state) {
    const EntityBox* const box = entity_at(state, 1);
    if (!box) return luaL_argerror(state, 1, "an entity is needed");
    begin_change(state);
    lua_pushboolean(state, context_of(state).world->destroy(box->entity));
    return 1;
}

int has(lua_State* state) {
    const Entity entity = check_alive(state, 1);
    lua_pushboolean(state, check_component(state, 2).type->find(*context_of(state).world, entity) != nullptr);
    return 1;
}

int remove(lua_State* state) {
    const Entity entity = check_alive(state, 1);
    const ComponentKey& key = check_component(state, 2);
    begin_change(state);
    lua_pushboolean(state, key.type->remove(*context_of(state).world, entity));
    return 1;
}

constexpr NamedFunction methods[] = {{"alive", alive},          {"destroy", bound<destroy>},
                                     {"has", bound<has>},       {"add", bound<add_component>},
                                     {"remove", bound<remove>}, {nullptr, nullptr}};

void push_name(lua_State* state, const World& world, Entity entity) {
    const Name* const found = world.find<Name>(entity);
    lua_pushlstring(state, found ? found->text.data() : "", found ? found->text.size() : 0);
}

void push_children(lua_State* state, const World& world, Entity entity) {
    const std::span<const Entity> below = world.children(entity);
    lua_createtable(state, static_cast<int>(below.size()), 0);
    for (std::size_t i = 0; i < below.size(); ++i) {
        push_entity(state, below[i]);
        lua_rawseti(state, -2, static_cast<lua_Integer>(i + 1));
    }
}

int get_member(lua_State* state) {
    Context& context = context_of(state);
    const int key = context.keys.find(state, 2);
    if (key >= first_method && key < ComponentKeys::first_component) {
        lua_rawgeti(state, lua_upvalueindex(1), key);
        return 1;
    }
    const Entity entity = check_alive(state, 1);
    const World& world = *context.world;
    switch (key) {
    case KeyMap::none:
        return luaL_error(state, "there is no component %s", luaL_tolstring(state, 2, nullptr));
    case name:
        push_name(state, world, entity);
        break;
    case parent:
        push_entity(state, world.parent(entity));
        break;
    case children:
        push_children(state, world, entity);
        break;
    default: {
        const ComponentKey& component = context.keys.component(key);
        if (component.type->find(world, entity))
            push_component(state, 1, component);
        else
            lua_pushnil(state);
    }
    }
    return 1;
}

void rename(World& world, Entity entity, std::string_view text) {
    world.set_if_different(entity, Name{std::string(text)});
}

int set_parent(lua_State* state, Entity entity) {
    World& world = *context_of(state).world;
    begin_change(state);
    if (lua_type(state, 3) == LUA_TNIL)
        world.clear_parent(entity);
    else
        world.set_parent(entity, check_alive(state, 3));
    return 0;
}

int set_member(lua_State* state) {
    const Entity entity = check_alive(state, 1);
    const int key = context_of(state).keys.find(state, 2);
    if (key == parent) return set_parent(state, entity);
    if (key != name)
        return luaL_error(state, "%s can't be assigned: assign to a field, as in e.gooch.b = 0.5, or e:add(...)",
                          luaL_tolstring(state, 2, nullptr));
    std::size_t length = 0;
    const char* const text = luaL_checklstring(state, 3, &length);
    begin_change(state);
    rename(*context_of(state).world, entity, {text, length});
    return 0;
}

int equal_entities(lua_State* state) {
    const EntityBox* const a = entity_at(state, 1);
    const EntityBox* const b = entity_at(state, 2);
    lua_pushboolean(state, a && b && a->entity == b->entity);
    return 1;
}

int entity_text(lua_State* state) {
    const EntityBox* const box = entity_at(state, 1);
    if (!box) return luaL_argerror(state, 1, "an entity is needed");
    const World& world = *context_of(state).world;
    if (const Name* const found = world.find<Name>(box->entity))
        lua_pushlstring(state, found->text.data(), found->text.size());
    else
        lua_pushfstring(state, "entity %dv%d", static_cast<int>(box->entity.index),
                        static_cast<int>(box->entity.generation));
    return 1;
}

constexpr NamedFunction entity_functions[] = {{"__newindex", bound<set_member>},
                                              {"__eq", equal_entities},
                                              {"__tostring", bound<entity_text>},
                                              {nullptr, nullptr}};

} // namespace

const EntityBox* entity_at(lua_State* state, int index) {
    return static_cast<const EntityBox*>(box_at(state, index, BoxKind::entity));
}

Entity check_alive(lua_State* state, int index) {
    const EntityBox* const box = entity_at(state, index);
    if (!box) luaL_argerror(state, index, "an entity is needed (is it called with a colon?)");
    if (!context_of(state).world->alive(box->entity)) luaL_error(state, "the entity is not alive");
    return box->entity;
}

void open_entities(lua_State* state) {
    Context& context = context_of(state);
    context.keys.add_member(state, "name", name);
    context.keys.add_member(state, "parent", parent);
    context.keys.add_member(state, "children", children);
    push_metatable(state, "entity", entity_functions);
    lua_newtable(state);
    int number = first_method;
    for (const NamedFunction* method = methods; method->name; ++method, ++number) {
        context.keys.add_member(state, method->name, number);
        lua_pushcfunction(state, method->function);
        lua_rawseti(state, -2, number);
    }
    lua_pushcclosure(state, bound<get_member>, 1);
    lua_setfield(state, -2, "__index");
    context.entity_methods = luaL_ref(state, LUA_REGISTRYINDEX);
    open_entity_cache(state);
}

} // namespace hachure::script
