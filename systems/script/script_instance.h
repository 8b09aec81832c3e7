#pragma once

#include <hachure/components/animation_events.h>
#include <hachure/components/scene_event.h>
#include <hachure/runtime/ecs/events.h>
#include <hachure/systems/script/script_context.h>

#include <cstdint>
#include <span>
#include <string>

namespace hachure::script {

/// A script that runs for an entity.
struct Instance {
    Entity entity;
    std::string file;               ///< as the component has it
    std::string chunk;              ///< what the file is called in messages
    int environment = 0;            ///< its globals, a reference in Lua's registry; 0 before it has begun
    bool stopped = false;           ///< by an error; it stays so until the file changes
    std::uint64_t random_key = 0;   ///< see random_bits
    std::uint64_t random_calls = 0; ///< so far
};

/// What happens to a script in a frame.
struct Turn {
    Instance* instance = nullptr;
    int program = 0; ///< the compiled file, a reference in Lua's registry
    double delta = 0;
    EventRange<SceneEvent> scene_events; ///< of others
    std::span<const SceneEvent> sent;    ///< by scripts in the frame before
    EventRange<ClipEvent> clip_events;
};

/// Runs the turn that is given as light userdata: the file itself and start() the first time, then event() for each
/// event that is the entity's, then update(). For Machine::protect.
int run_turn(lua_State* state);

/// Compiles the text of a file, and gives the reference of the program. For Machine::protect.
struct Compilation {
    const std::string* text = nullptr;
    int program = 0; ///< result
};
int compile(lua_State* state);

/// What stands before the text of each file, on its first line: the environment comes as an argument, so that a
/// program serves many.
inline constexpr const char* prologue = "local _ENV = ...; ";

} // namespace hachure::script
