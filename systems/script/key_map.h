#pragma once

#include <cstddef>
#include <deque>
#include <string_view>
#include <utility>
#include <vector>

struct lua_State;

namespace hachure::script {

/// Finds numbers by names that scripts use. Lua keeps one copy of each short text; the map holds on to those of its
/// names, so that a name is known by its address.
class KeyMap {
public:
    static constexpr int none = -1;

    /// Adds a name, which outlives the map, with a number from 0. Calls Lua, which may raise an error.
    void add(lua_State* state, std::string_view name, int value);

    /// The number of the text at `index`; `none` when it is another value or text.
    [[nodiscard]] int find(lua_State* state, int index) const;

private:
    struct Slot {
        const char* key = nullptr;
        int value = none;
    };

    void grow();
    [[nodiscard]] std::size_t place(const char* key) const;

    std::vector<Slot> slots_; ///< open addressing; a power of two, at most half full
    std::size_t used_ = 0;
    std::vector<std::pair<std::string_view, int>> long_; ///< texts that Lua may have many copies of
};

} // namespace hachure::script
