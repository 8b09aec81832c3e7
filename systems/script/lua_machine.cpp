#include <hachure/runtime/assert.h>
#include <hachure/runtime/error.h>
#include <hachure/systems/script/lua_machine.h>

#include <fmt/format.h>
#include <lua5.4/lua.hpp>

#include <charconv>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <string_view>
#include <utility>

namespace hachure::script {
namespace {

constexpr std::size_t bytes_per_step = 64;

double thread_seconds() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// The line of the innermost function that has lines; 0 when there is none. Allocates nothing.
int current_line(lua_State* state) {
    lua_Debug frame;
    for (int level = 0; state && lua_getstack(state, level, &frame); ++level)
        if (lua_getinfo(state, "l", &frame) && frame.currentline > 0) return frame.currentline;
    return 0;
}

[[noreturn]] int panic(lua_State*) {
    HACHURE_ASSERT(false, "Lua raised an error outside a protected call");
    std::abort();
}

} // namespace

void Machine::Close::operator()(lua_State* state) const { lua_close(state); }

Machine& Machine::of(lua_State* state) { return **static_cast<Machine**>(lua_getextraspace(state)); }

Machine::Machine(void* owner) : owner_(owner), state_(lua_newstate(allocate, this)) {
    if (!state_) throw Error("scripts", "there is no memory for them");
    *static_cast<Machine**>(lua_getextraspace(state())) = this; // coroutines get a copy
    lua_atpanic(state(), panic);
    lua_sethook(state(), hook, LUA_MASKCOUNT, hook_interval);
}

void* Machine::allocate(void* self, void* block, std::size_t old_size, std::size_t new_size) {
    Machine& machine = *static_cast<Machine*>(self);
    const std::size_t held = block ? old_size : 0;
    if (new_size == 0) {
        std::free(block);
        machine.used_ -= held;
        return nullptr;
    }
    if (new_size > held) {
        // Of a new object Lua says the kind in place of the old size.
        const bool text = !block && old_size == LUA_TSTRING && new_size > machine.limits_.text + 64;
        if (text || machine.used_ - held + new_size > machine.limits_.memory) {
            machine.refuse(text);
            return nullptr;
        }
        machine.refused_ = false;
        machine.steps_left_ -= static_cast<std::int64_t>((new_size - held) / bytes_per_step);
    }
    void* const result = std::realloc(block, new_size);
    if (result) machine.used_ += new_size - held;
    return result;
}

void Machine::refuse(bool text) {
    if (stopped_) return;
    line_ = current_line(running_);
    // After the first refusal Lua collects what is garbage, and asks again.
    if (!std::exchange(refused_, true) || !in_turn_) return;
    stopped_ = true;
    reason_ = text ? fmt::format("a text of more than {} bytes", limits_.text)
                   : fmt::format("scripts hold more than {} bytes of memory", limits_.memory);
}

void Machine::hook(lua_State* state, lua_Debug*) {
    Machine& machine = of(state);
    if (!machine.in_turn_) return;
    machine.charge(state, hook_interval);
    machine.raise_if_stopped(state);
    if (machine.out_of_time()) machine.stop(state, "the script takes too long");
}

void Machine::charge(lua_State* state, std::int64_t steps) {
    steps_left_ -= steps;
    if (steps_left_ >= 0 || stopped_) return;
    stop(state, "too many steps in one frame (does a loop not end?)");
}

void Machine::stop(lua_State* at, const char* reason) {
    stopped_ = true;
    line_ = current_line(at);
    try {
        reason_ = reason;
    } catch (const std::bad_alloc&) {
        reason_.clear();
    }
    raise_if_stopped(at);
}

void Machine::raise_if_stopped(lua_State* state) const {
    if (!stopped_) return;
    // Whatever still runs, such as the ends of variables to be closed, gets one instruction.
    lua_sethook(state, hook, LUA_MASKCOUNT, 1);
    lua_pushliteral(state, "the script is stopped");
    lua_error(state);
}

bool Machine::out_of_time() const {
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - turn_began_;
    // A machine that does other things, too, is not the script's fault; asking for that takes longer, though.
    return passed.count() > limits_.seconds && thread_seconds() - frame_began_ > limits_.seconds;
}

void Machine::begin_frame(const ScriptLimits& limits) {
    limits_ = limits;
    frame_began_ = thread_seconds();
}

void Machine::begin_turn(std::string_view chunk) {
    chunk_ = chunk;
    turn_began_ = std::chrono::steady_clock::now();
    steps_left_ = limits_.steps;
    refused_ = false;
    if (std::exchange(stopped_, false)) lua_sethook(state(), hook, LUA_MASKCOUNT, hook_interval);
}

int Machine::note_place(lua_State* state) {
    Machine& machine = of(state);
    if (!machine.stopped_) machine.line_ = current_line(state);
    return 1;
}

std::optional<Fault> Machine::protect(int (*body)(lua_State*), void* argument) {
    lua_State* const lua = state();
    HACHURE_ASSERT(!in_turn_ && lua_gettop(lua) == 0, "scripts run one after another");
    line_ = 0;
    in_turn_ = true;
    running_ = lua;
    lua_pushcfunction(lua, note_place);
    lua_pushcfunction(lua, body);
    lua_pushlightuserdata(lua, argument);
    const int status = lua_pcall(lua, 1, 0, 1);
    in_turn_ = false;
    running_ = nullptr;
    std::optional<Fault> fault;
    if (status != LUA_OK || stopped_) fault = fault_of(status);
    lua_settop(lua, 0);
    return fault;
}

Fault Machine::fault_of(int status) const {
    if (stopped_) return {line_, reason_};
    if (status == LUA_ERRMEM) return {line_, fmt::format("scripts hold more than {} bytes of memory", limits_.memory)};
    lua_State* const lua = state();
    if (lua_type(lua, -1) != LUA_TSTRING)
        return {line_, fmt::format("the error is a {} and no text", luaL_typename(lua, -1))};
    std::size_t length = 0;
    const char* const text = lua_tolstring(lua, -1, &length);
    Fault fault{line_, std::string(text, length)};
    // The message knows better than the stack: an error of a coroutine comes from there.
    if (fault.message.starts_with(chunk_ + ':')) {
        const char* const begin = fault.message.data() + chunk_.size() + 1;
        const char* const end = fault.message.data() + fault.message.size();
        const auto number = std::from_chars(begin, end, fault.line);
        if (number.ec == std::errc() && end - number.ptr >= 2 && number.ptr[0] == ':' && number.ptr[1] == ' ')
            fault.message.erase(0, static_cast<std::size_t>(number.ptr + 2 - fault.message.data()));
    }
    return fault;
}

} // namespace hachure::script
