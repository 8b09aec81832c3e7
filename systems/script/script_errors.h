#pragma once

#include <hachure/runtime/ecs/entity.h>

#include <string>
#include <vector>

namespace hachure {

/// Why a script was stopped.
struct ScriptError {
    Entity entity;       ///< that carries the script; may be dead by now
    std::string file;    ///< as the component has it
    int line = 0;        ///< in the file, from 1; 0 when the fault is the whole file's
    std::string message; ///< as it was logged: "fox.lua:12: what is wrong"
};

/// Resource: the scripts that failed so far, in order of time. Whoever has seen them may clear it.
struct ScriptErrors {
    std::vector<ScriptError> errors;
};

} // namespace hachure
