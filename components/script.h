#pragma once

#include <hachure/runtime/ecs/reflect.h>

#include <string>

namespace hachure {

/// Logic of the user's own: a Lua file whose functions start(), update(dt) and event(name, entity) run for the entity
/// that carries it. docs/scripts.md says what scripts can do.
struct Script {
    std::string file;    ///< another file starts anew
    bool enabled = true; ///< false keeps what the script holds, and calls nothing

    friend bool operator==(const Script&, const Script&) = default;
};

inline void reflect(TypeBuilder<Script>& type) {
    type.name("script").doc("a Lua program that moves this entity and others");
    type.field("file", &Script::file).doc("Lua file").unit("file");
    type.field("enabled", &Script::enabled).doc("whether its functions are called");
}

} // namespace hachure
