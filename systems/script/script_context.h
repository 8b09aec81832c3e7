#pragma once

#include <hachure/components/name_index.h>
#include <hachure/components/scene_event.h>
#include <hachure/runtime/ecs/reflect.h>
#include <hachure/runtime/ecs/world.h>
#include <hachure/systems/script/component_keys.h>
#include <hachure/systems/script/lua_machine.h>

#include <cstdint>
#include <string>
#include <vector>

namespace hachure::script {

/// About what it costs, beside an instruction of Lua, to add or remove a component or to destroy an entity.
inline constexpr std::int64_t steps_of_a_structural_change = 50;

/// What the functions that scripts call work on. It outlives the Lua state.
struct Context {
    explicit Context(const TypeRegistry& registry) : types(&registry) {}

    const TypeRegistry* types;
    World* world = nullptr; ///< set while scripts run

    /// Another number in each frame, and after each structural change: pointers to components hold as long as it does.
    std::uint64_t structure = 1;

    NameIndex names;

    // Of the script whose turn it is.
    Entity self;
    std::uint64_t random_key = 0;          ///< the seed and who the script is
    std::uint64_t* random_calls = nullptr; ///< made so far

    // Of the frame.
    double seconds = 0;
    std::uint64_t frame = 0;
    std::vector<SceneEvent> sent; ///< by scripts, to be given to scripts in the next frame

    // Kept here, since errors of Lua jump over the end of C++ objects.
    std::string fault;              ///< about to be raised
    std::vector<Entity> entities;   ///< being collected
    std::vector<FieldValue> values; ///< being checked

    // What is anchored in Lua's registry.
    int globals = 0;        ///< what all scripts see
    int entity_cache = 0;   ///< by slot + 1
    int weak_table = 0;     ///< the metatable that lets it forget
    bool forgetful = false; ///< the cache has that metatable
    int entity_methods = 0; ///< metatables
    int component_methods = 0;
    int vector_methods[4] = {}; ///< vec2, vec3, vec4, quat
    ComponentKeys keys;

    Machine* machine = nullptr;
};

/// The context of a state or coroutine.
[[nodiscard]] inline Context& context_of(lua_State* state) { return *static_cast<Context*>(Machine::owner_of(state)); }

} // namespace hachure::script
