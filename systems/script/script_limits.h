#pragma once

#include <cstddef>
#include <cstdint>

namespace hachure {

/// Resource: what scripts may use. One that asks for more is stopped, with a line that says of what.
struct ScriptLimits {
    /// Bytes that all scripts of the program hold together.
    std::size_t memory = std::size_t{64} << 20;

    /// Steps of one script in one frame: instructions of Lua, and as many for what functions of the house do as take
    /// about as long.
    std::int64_t steps = 10'000'000;

    /// Bytes of one string, and of a script's file.
    std::size_t text = std::size_t{1} << 20;

    /// Seconds of computing time of one script in one frame. A second line of defence, for what steps count badly.
    double seconds = 5.0;
};

} // namespace hachure
