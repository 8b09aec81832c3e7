#include <hachure/components/scene_event.h>
#include <hachure/runtime/ecs/events.h>
#include <hachure/runtime/error.h>
#include <hachure/runtime/scene/spawner.h>
#include <hachure/systems/script/lua_binding.h>
#include <hachure/systems/script/lua_entity.h>
#include <hachure/systems/script/script_api.h>
#include <hachure/systems/script/script_context.h>

#include <lua5.4/lua.hpp>

#include <string>
#include <string_view>

namespace hachure::script {
namespace {

// What these cost beside an instruction of Lua, so that a loop without end does not fill the world first.
constexpr std::int64_t steps_of_spawning = 10'000, steps_of_sending = 100, steps_of_finding = 10;

int find(lua_State* state) {
    Context& context = context_of(state);
    const std::string_view path = check_text(state, 1);
    context.machine->charge(state, steps_of_finding + static_cast<std::int64_t>(path.size()));
    context.names.update(*context.world);
    push_entity(state, context.names.find(*context.world, path));
    return 1;
}

int find_all(lua_State* state) {
    Context& context = context_of(state);
    const std::string_view path = check_text(state, 1);
    context.machine->charge(state, steps_of_finding + static_cast<std::int64_t>(path.size()));
    context.names.update(*context.world);
    context.entities = context.names.find_all(*context.world, path);
    context.machine->charge(state, static_cast<std::int64_t>(context.entities.size()));
    lua_createtable(state, static_cast<int>(context.entities.size()), 0);
    for (std::size_t i = 0; i < context.entities.size(); ++i) {
        push_entity(state, context.entities[i]);
        lua_rawseti(state, -2, static_cast<lua_Integer>(i + 1));
    }
    return 1;
}

/// Pushes the field of the options at 2, and returns its type.
int option(lua_State* state, const char* name) {
    lua_pushstring(state, name);
    return lua_rawget(state, 2);
}

Entity spawn_entity(World& world, std::string_view what, std::string_view name, Entity parent) {
    const Spawner* const spawner = world.find_resource<Spawner>();
    if (!spawner || !spawner->spawn) throw Error("scene.spawn", "this program has nothing to spawn from");
    return spawner->spawn(world, {std::string(what), parent, std::string(name)});
}

int spawn(lua_State* state) {
    Context& context = context_of(state);
    const std::string_view what = check_text(state, 1);
    std::string_view name;
    Entity parent;
    lua_settop(state, 2);
    if (lua_type(state, 2) != LUA_TNIL) {
        luaL_checktype(state, 2, LUA_TTABLE);
        if (option(state, "name") != LUA_TNIL) name = check_text(state, -1);
        if (option(state, "parent") != LUA_TNIL) parent = check_alive(state, -1);
    }
    context.machine->charge(state, steps_of_spawning);
    ++context.structure;
    push_entity(state, spawn_entity(*context.world, what, name, parent));
    return 1;
}

void send_to(Context& context, Entity entity, std::string_view name) {
    context.sent.push_back({entity, std::string(name)});
    send_event(*context.world, context.sent.back());
}

int send(lua_State* state) {
    const std::string_view name = check_text(state, 1);
    const Entity entity = lua_isnoneornil(state, 2) ? Entity::null : check_alive(state, 2);
    context_of(state).machine->charge(state, steps_of_sending + static_cast<std::int64_t>(name.size()));
    send_to(context_of(state), entity, name);
    return 0;
}

constexpr NamedFunction scene_functions[] = {{"find", bound<find>},
                                             {"find_all", bound<find_all>},
                                             {"spawn", bound<spawn>},
                                             {"send", bound<send>},
                                             {nullptr, nullptr}};

} // namespace

void open_scene(lua_State* state) {
    lua_newtable(state);
    set_functions(state, scene_functions);
    open_query(state);
    protect_table(state, "scene");
    lua_setfield(state, -2, "scene");
}

} // namespace hachure::script
