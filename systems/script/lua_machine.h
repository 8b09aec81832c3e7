#pragma once

#include <hachure/systems/script/script_limits.h>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

struct lua_Debug;
struct lua_State;

namespace hachure::script {

/// What ended a protected call.
struct Fault {
    int line = 0;        ///< in the script's file, from 1; 0 when unknown
    std::string message; ///< without file and line
};

/// A Lua state whose memory and work are bounded. Work is counted in steps: instructions of Lua by a hook, which runs
/// each `hook_interval` of them, bytes that are allocated, and what C functions `charge`.
///
/// A stop (of steps, memory, text or time) is more than an error: from then on every function that could catch it
/// raises it again, and every instruction fails, until the next turn begins.
class Machine {
public:
    static constexpr int hook_interval = 1000;

    /// `owner` is what `owner_of` gives to functions. Throws Error when there is no memory.
    explicit Machine(void* owner);
    ~Machine() = default;
    Machine(const Machine&) = delete;
    Machine& operator=(const Machine&) = delete;

    [[nodiscard]] lua_State* state() const { return state_.get(); }
    [[nodiscard]] static Machine& of(lua_State* state);
    [[nodiscard]] static void* owner_of(lua_State* state) { return of(state).owner_; }

    /// Begins a frame with these limits.
    void begin_frame(const ScriptLimits& limits);

    /// Begins the turn of a script, with all its steps. `chunk` is what its file is called in messages.
    void begin_turn(std::string_view chunk);

    /// Calls `body(state)` with `argument` as light userdata on an otherwise empty stack, and takes what it raises.
    std::optional<Fault> protect(int (*body)(lua_State*), void* argument);

    /// Counts work that is done on behalf of a script. Raises a stop in `state` when there was too much.
    void charge(lua_State* state, std::int64_t steps);

    /// Raises the stop again if there is one: for functions that have caught something.
    void raise_if_stopped(lua_State* state) const;
    [[nodiscard]] bool stopped() const { return stopped_; }

    /// The state or coroutine that runs; functions that resume coroutines keep it up to date.
    void set_running(lua_State* state) { running_ = state; }

    [[nodiscard]] std::size_t memory() const { return used_; }
    [[nodiscard]] std::int64_t steps_left() const { return steps_left_; }
    [[nodiscard]] const ScriptLimits& limits() const { return limits_; }
    [[nodiscard]] const std::string& chunk() const { return chunk_; }

private:
    struct Close {
        void operator()(lua_State* state) const;
    };

    static void* allocate(void* self, void* block, std::size_t old_size, std::size_t new_size);
    static void hook(lua_State* state, lua_Debug* at);
    static int note_place(lua_State* state);
    void refuse(bool text);
    void stop(lua_State* at, const char* reason);
    [[nodiscard]] bool out_of_time() const;
    [[nodiscard]] Fault fault_of(int status) const;

    void* owner_;
    ScriptLimits limits_;
    std::size_t used_ = 0; ///< bytes
    std::int64_t steps_left_ = 0;
    std::chrono::steady_clock::time_point turn_began_;
    double frame_began_ = 0; ///< seconds of this thread's computing time
    std::string chunk_;
    bool in_turn_ = false;
    bool refused_ = false; ///< memory, since something was last granted
    bool stopped_ = false;
    std::string reason_;
    int line_ = 0; ///< where the last stop, refusal or error was
    lua_State* running_ = nullptr;
    std::unique_ptr<lua_State, Close> state_; ///< last, since it frees through the above
};

} // namespace hachure::script
