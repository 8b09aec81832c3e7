#include <hachure/components/name.h>
#include <hachure/components/script.h>
#include <hachure/runtime/app/log.h>
#include <hachure/runtime/assets/text_file.h>
#include <hachure/runtime/error.h>
#include <hachure/runtime/scene/scene_seed.h>
#include <hachure/systems/script/lua_binding.h>
#include <hachure/systems/script/lua_entity.h>
#include <hachure/systems/script/sandbox.h>
#include <hachure/systems/script/script_engine.h>
#include <hachure/systems/script/script_random.h>

#include <fmt/format.h>
#include <lua5.4/lua.hpp>

#include <algorithm>
#include <filesystem>

namespace hachure::script {
namespace {

constexpr std::size_t longest_chunk = 50; ///< what of a name Lua shows in messages

/// What is said fits on a line, as every Error does: Lua quotes what it does not understand, which may be half a
/// program.
std::string one_line(std::string_view message) {
    constexpr std::size_t longest = 300; // bytes
    const bool fits = message.size() <= longest;
    return Error(fits ? std::string(message) : fmt::format("{} ...", message.substr(0, longest))).what();
}

/// What a file is called in messages.
std::string chunk_of(const std::string& file) {
    const std::string name = std::filesystem::path(file).filename().string();
    return name.size() <= longest_chunk ? name : "..." + name.substr(name.size() - longest_chunk + 3);
}

/// Who the entity is, in every run: its path of names, below the seed of the scene.
std::uint64_t random_key(const World& world, Entity entity) {
    const SceneSeed* const seed = world.find_resource<SceneSeed>();
    std::uint64_t key = mix((seed ? *seed : SceneSeed()).value);
    for (; entity; entity = world.parent(entity)) {
        const Name* const name = world.find<Name>(entity);
        key = extend_key(key, name ? name->text : std::string_view());
    }
    return key;
}

int open_state(lua_State* state) {
    lua_settop(state, 0);
    open_sandbox(state);
    return 0;
}

int begin_frame(lua_State* state) {
    Context& context = context_of(state);
    context.keys.update(state, *context.types);
    trim_entities(state);
    return 0;
}

} // namespace

void ScriptEngine::open() {
    machine_ = std::make_unique<Machine>(&context_);
    context_.machine = machine_.get();
    machine_->begin_frame({});
    machine_->begin_turn("scripts");
    if (const auto fault = machine_->protect(bound<open_state>, nullptr)) throw Error("scripts", fault->message);
}

void ScriptEngine::run(World& world, const Time& time) {
    scripts_.clear();
    world.query<const Script>().each([this](Entity entity, const Script& script) {
        if (script.enabled && !script.file.empty()) scripts_.push_back(entity);
    });
    if (scripts_.empty() && instances_.empty()) return;
    std::ranges::sort(scripts_);
    if (!machine_) open();
    const ScriptLimits* const limits = world.find_resource<ScriptLimits>();
    machine_->begin_frame(limits ? *limits : ScriptLimits());
    machine_->begin_turn("scripts");
    if (const auto fault = machine_->protect(bound<begin_frame>, nullptr)) throw Error("scripts", fault->message);
    forget_gone(world);
    context_.world = &world;
    ++context_.structure;
    context_.seconds = time.elapsed;
    context_.frame = time.frame;
    Turn turn;
    turn.delta = time.delta;
    turn.scene_events = events_since<SceneEvent>(world, seen_);
    turn.clip_events = events_since<ClipEvent>(world, seen_);
    seen_ = world.tick();
    sent_.clear(); // what scripts send has this tick, too, and comes in the next frame
    sent_.swap(context_.sent);
    turn.sent = sent_;
    for (const Entity entity : scripts_) run_script(world, entity, turn);
    context_.world = nullptr;
}

void ScriptEngine::forget_gone(const World& world) {
    std::erase_if(instances_, [&](const auto& entry) {
        const bool gone = !world.has<Script>(entry.first);
        if (gone) release(*entry.second);
        return gone;
    });
}

void ScriptEngine::run_script(World& world, Entity entity, Turn& turn) {
    const Script* const script = world.find<Script>(entity);
    if (!script || !script->enabled) return; // another script was first
    Instance& instance = instance_of(world, entity, script->file);
    if (instance.stopped) return;
    const Program& program = program_of(instance.file);
    if (program.fault) return stop(world, instance, *program.fault);
    context_.self = entity;
    context_.random_key = instance.random_key;
    context_.random_calls = &instance.random_calls;
    turn.instance = &instance;
    turn.program = program.reference;
    machine_->begin_turn(instance.chunk);
    if (const auto fault = machine_->protect(bound<run_turn>, &turn)) stop(world, instance, *fault);
}

Instance& ScriptEngine::instance_of(const World& world, Entity entity, const std::string& file) {
    std::unique_ptr<Instance>& instance = instances_[entity];
    if (instance && instance->file == file) return *instance;
    if (instance) release(*instance);
    instance = std::make_unique<Instance>();
    instance->entity = entity;
    instance->file = file;
    instance->chunk = chunk_of(file);
    const std::uint64_t key = random_key(world, entity);
    instance->random_key = mix(key ^ alike_[key]++);
    return *instance;
}

const ScriptEngine::Program& ScriptEngine::program_of(const std::string& file) {
    const auto [entry, added] = programs_.try_emplace(file);
    if (added) entry->second.fault = compile_file(file, entry->second.reference);
    return entry->second;
}

std::optional<Fault> ScriptEngine::compile_file(const std::string& file, int& program) {
    std::string text;
    try {
        if (std::filesystem::path(file).extension() != ".lua") return Fault{0, "the name of a script ends with .lua"};
        text = assets::read_text_file(file, machine_->limits().text);
    } catch (const Error& error) {
        const std::string_view message = error.what();
        const std::string subject = file + ": ";
        return Fault{0, std::string(message.starts_with(subject) ? message.substr(subject.size()) : message)};
    }
    if (text.starts_with(LUA_SIGNATURE)) return Fault{0, "this is compiled, and a script is text"};
    text.insert(0, prologue);
    Compilation compilation{&text};
    machine_->begin_turn(chunk_of(file));
    auto fault = machine_->protect(bound<compile>, &compilation);
    program = compilation.program;
    return fault;
}

void ScriptEngine::stop(World& world, Instance& instance, const Fault& fault) {
    instance.stopped = true;
    release(instance);
    lua_gc(machine_->state(), LUA_GCCOLLECT); // others may need what it held
    const std::string& chunk = instance.chunk;
    const std::string what = one_line(fault.message);
    std::string message =
        fault.line > 0 ? fmt::format("{}:{}: {}", chunk, fault.line, what) : fmt::format("{}: {}", chunk, what);
    if (logged_.insert(message).second) log_warning(message);
    ScriptErrors* errors = world.find_resource<ScriptErrors>();
    if (!errors) errors = &world.set_resource(ScriptErrors{});
    errors->errors.push_back({instance.entity, instance.file, fault.line, std::move(message)});
}

void ScriptEngine::release(Instance& instance) {
    if (instance.environment != 0) luaL_unref(machine_->state(), LUA_REGISTRYINDEX, instance.environment);
    instance.environment = 0;
}

} // namespace hachure::script
