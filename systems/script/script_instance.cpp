#include <hachure/components/script.h>
#include <hachure/systems/script/lua_entity.h>
#include <hachure/systems/script/script_instance.h>

#include <lua5.4/lua.hpp>

namespace hachure::script {
namespace {

constexpr int environment = 1; ///< its place on the stack

/// What runs may have ended the entity, or taken the script off it.
bool goes_on(const Context& context, const Instance& instance) {
    const Script* const script = context.world->find<Script>(instance.entity);
    return script && script->enabled && script->file == instance.file;
}

/// Pushes the script's function of that name; nothing, and false, when it has none.
bool push_function(lua_State* state, const char* name) {
    lua_pushstring(state, name);
    const int type = lua_rawget(state, environment);
    if (type == LUA_TFUNCTION) return true;
    if (type != LUA_TNIL)
        luaL_error(state, "%s: %s is a %s and no function", Machine::of(state).chunk().c_str(), name,
                   luaL_typename(state, -1));
    lua_pop(state, 1);
    return false;
}

/// Pushes the globals of a new script.
void push_environment(lua_State* state, const Instance& instance) {
    lua_newtable(state);
    push_entity(state, instance.entity);
    lua_setfield(state, -2, "self");
    lua_pushvalue(state, -1);
    lua_setfield(state, -2, "_G");
    lua_createtable(state, 0, 2);
    lua_rawgeti(state, LUA_REGISTRYINDEX, context_of(state).globals);
    lua_setfield(state, -2, "__index");
    lua_pushboolean(state, 0);
    lua_setfield(state, -2, "__metatable");
    lua_setmetatable(state, -2);
}

void begin(lua_State* state, Turn& turn) {
    push_environment(state, *turn.instance);
    lua_pushvalue(state, environment);
    turn.instance->environment = luaL_ref(state, LUA_REGISTRYINDEX);
    lua_rawgeti(state, LUA_REGISTRYINDEX, turn.program);
    lua_pushvalue(state, environment);
    lua_call(state, 1, 0);
    if (goes_on(context_of(state), *turn.instance) && push_function(state, "start")) lua_call(state, 0, 0);
}

void send_event(lua_State* state, const Instance& instance, const std::string& name, Entity entity) {
    if (!goes_on(context_of(state), instance) || !push_function(state, "event")) return;
    lua_pushlstring(state, name.data(), name.size());
    push_entity(state, entity);
    lua_call(state, 2, 0);
}

void send_event(lua_State* state, const Instance& instance, const SceneEvent& event) {
    if (!event.entity || event.entity == instance.entity) send_event(state, instance, event.name, event.entity);
}

/// Whether `entity` is `ancestor` or below it.
bool is_at_or_below(const World& world, Entity entity, Entity ancestor) {
    while (entity && entity != ancestor) entity = world.parent(entity);
    return entity == ancestor;
}

} // namespace

int run_turn(lua_State* state) {
    Turn& turn = *static_cast<Turn*>(lua_touserdata(state, 1));
    const Context& context = context_of(state);
    Instance& instance = *turn.instance;
    lua_settop(state, 0);
    if (instance.environment == 0)
        begin(state, turn);
    else
        lua_rawgeti(state, LUA_REGISTRYINDEX, instance.environment);
    for (const SceneEvent& event : turn.sent) send_event(state, instance, event);
    for (const SceneEvent& event : turn.scene_events) send_event(state, instance, event);
    for (const ClipEvent& event : turn.clip_events)
        if (is_at_or_below(*context.world, event.model, instance.entity))
            send_event(state, instance, event.name, event.model);
    if (goes_on(context, instance) && push_function(state, "update")) {
        lua_pushnumber(state, turn.delta);
        lua_call(state, 1, 0);
    }
    return 0;
}

int compile(lua_State* state) {
    auto& compilation = *static_cast<Compilation*>(lua_touserdata(state, 1));
    // As text only: bytecode is not checked by Lua.
    lua_pushfstring(state, "=%s", Machine::of(state).chunk().c_str());
    const int status =
        luaL_loadbufferx(state, compilation.text->data(), compilation.text->size(), lua_tostring(state, -1), "t");
    if (status != LUA_OK) return lua_error(state);
    compilation.program = luaL_ref(state, LUA_REGISTRYINDEX);
    return 0;
}

} // namespace hachure::script
