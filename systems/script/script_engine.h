#pragma once

#include <hachure/runtime/ecs/time.h>
#include <hachure/systems/script/script_errors.h>
#include <hachure/systems/script/script_instance.h>

#include <memory>
#include <optional>
#include <set>
#include <string>
#include <unordered_map>
#include <vector>

namespace hachure::script {

/// Runs the scripts of a world, which is the same each time.
class ScriptEngine {
public:
    explicit ScriptEngine(const TypeRegistry& types) : context_(types) {}
    ScriptEngine(const ScriptEngine&) = delete;
    ScriptEngine& operator=(const ScriptEngine&) = delete;

    /// A frame of all scripts, in order of their entities' slots.
    void run(World& world, const Time& time);

private:
    /// A file, compiled once.
    struct Program {
        int reference = 0;          ///< in Lua's registry
        std::optional<Fault> fault; ///< why there is none
    };

    void open();
    void forget_gone(const World& world);
    Instance& instance_of(const World& world, Entity entity, const std::string& file);
    const Program& program_of(const std::string& file);
    std::optional<Fault> compile_file(const std::string& file, int& program);
    void run_script(World& world, Entity entity, Turn& turn);
    void stop(World& world, Instance& instance, const Fault& fault);
    void release(Instance& instance);

    Context context_;
    std::unique_ptr<Machine> machine_; ///< made with the first script
    std::unordered_map<Entity, std::unique_ptr<Instance>> instances_;
    std::unordered_map<std::string, Program> programs_;      ///< by file
    std::unordered_map<std::uint64_t, std::uint64_t> alike_; ///< how many scripts had a random key so far
    std::set<std::string> logged_;                           ///< so that a hundred of a kind say it once
    std::vector<Entity> scripts_;                            ///< of this frame
    std::vector<SceneEvent> sent_;                           ///< by scripts in the frame before
    Tick seen_ = 0;                                          ///< events up to here have been given
};

} // namespace hachure::script
