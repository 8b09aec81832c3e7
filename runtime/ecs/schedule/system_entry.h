#pragma once

#include <hachure/runtime/ecs/access.h>
#include <hachure/runtime/ecs/commands.h>
#include <hachure/runtime/ecs/schedule/system.h>
#include <hachure/runtime/ecs/stage.h>
#include <hachure/runtime/ecs/tick.h>

#include <memory>
#include <string>
#include <vector>

namespace hachure::detail {

/// One system of a schedule.
struct SystemEntry {
    Stage stage;
    std::string name;
    std::unique_ptr<Callable<void>> body;
    Access access; ///< of the body and the conditions

    std::vector<std::unique_ptr<Callable<bool>>> conditions{};
    std::vector<std::string> before{};
    std::vector<std::string> after{};
    bool fixed = false;

    std::unique_ptr<Commands> commands{}; ///< made before the first run, where access.commands
    const World* commands_world = nullptr;
    Tick now = 0;  ///< of this run
    Tick last = 0; ///< see LastRun
    double ms = 0; ///< in this run of the schedule
};

} // namespace hachure::detail
