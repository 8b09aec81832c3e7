#include <hachure/systems/script/lua_entity.h>
#include <hachure/systems/script/script_api.h>
#include <hachure/systems/script/script_context.h>

#include <lua5.4/lua.hpp>

#include <algorithm>
#include <cstring>

namespace hachure::script {
namespace {

constexpr int most_components = 8;

/// A walk over entities that were collected when it began; they follow the box in memory.
struct QueryBox {
    BoxKind kind = BoxKind::query;
    std::uint32_t count = 0;
    std::uint32_t next = 0;
    int key_count = 0;
    std::uint64_t structure = 0; ///< in which all of them have all components
    const ComponentKey* keys[most_components] = {};

    Entity* entities() { return reinterpret_cast<Entity*>(this + 1); }
};
static_assert(sizeof(QueryBox) % alignof(Entity) == 0);

bool has_all(const QueryBox& query, const World& world, Entity entity) {
    for (int i = 0; i < query.key_count; ++i)
        if (!query.keys[i]->type->find(world, entity)) return false;
    return true;
}

/// Fills `entities` with those that have all components, in order of their slots: the order of tables depends on which
/// components came and went.
void collect(const World& world, const QueryBox& query, std::vector<Entity>& entities) {
    entities.clear();
    query.keys[0]->type->each(
        world,
        [](void* list, Entity entity, const void*) { static_cast<std::vector<Entity>*>(list)->push_back(entity); },
        &entities);
    if (query.key_count > 1) std::erase_if(entities, [&](Entity entity) { return !has_all(query, world, entity); });
    if (!std::ranges::is_sorted(entities)) std::ranges::sort(entities);
}

/// The next entity and its components; those that died or lost one since the walk began are left out.
int next_entity(lua_State* state) {
    auto& query = *static_cast<QueryBox*>(lua_touserdata(state, lua_upvalueindex(1)));
    const Context& context = context_of(state);
    while (query.next < query.count) {
        const Entity entity = query.entities()[query.next++];
        if (query.structure != context.structure && !has_all(query, *context.world, entity)) continue;
        push_entity(state, entity);
        const int at = lua_gettop(state);
        for (int i = 0; i < query.key_count; ++i) push_component(state, at, *query.keys[i]);
        return 1 + query.key_count;
    }
    return 0;
}

int begin_query(lua_State* state) {
    Context& context = context_of(state);
    QueryBox query;
    query.key_count = lua_gettop(state);
    if (query.key_count == 0 || query.key_count > most_components)
        return luaL_error(state, "scene.query takes the names of 1 to %d components", most_components);
    for (int i = 0; i < query.key_count; ++i) query.keys[i] = &check_component(state, i + 1);
    collect(*context.world, query, context.entities);
    query.count = static_cast<std::uint32_t>(context.entities.size());
    query.structure = context.structure;
    context.machine->charge(state, query.count / 4);
    void* const box = lua_newuserdatauv(state, sizeof(QueryBox) + query.count * sizeof(Entity), 0);
    std::memcpy(box, &query, sizeof query);
    std::ranges::copy(context.entities, static_cast<QueryBox*>(box)->entities());
    lua_pushcclosure(state, bound<next_entity>, 1);
    return 1;
}

} // namespace

void open_query(lua_State* state) {
    lua_pushcfunction(state, bound<begin_query>);
    lua_setfield(state, -2, "query");
}

} // namespace hachure::script
