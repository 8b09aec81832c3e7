#include <hachure/systems/script/key_map.h>

#include <lua5.4/lua.hpp>

#include <cstdint>

namespace hachure::script {
namespace {
constexpr std::size_t longest_short_text = 40; // LUAI_MAXSHORTLEN
}

void KeyMap::add(lua_State* state, std::string_view name, int value) {
    if (name.size() > longest_short_text) {
        long_.emplace_back(name, value);
        return;
    }
    const char* const key = lua_pushlstring(state, name.data(), name.size());
    luaL_ref(state, LUA_REGISTRYINDEX);
    if (2 * (used_ + 1) > slots_.size()) grow();
    slots_[place(key)] = {key, value};
    ++used_;
}

int KeyMap::find(lua_State* state, int index) const {
    if (lua_type(state, index) != LUA_TSTRING) return none;
    std::size_t length = 0;
    const char* const key = lua_tolstring(state, index, &length);
    if (length > longest_short_text) {
        for (const auto& [name, value] : long_)
            if (name == std::string_view(key, length)) return value;
        return none;
    }
    return slots_.empty() ? none : slots_[place(key)].value;
}

void KeyMap::grow() {
    std::vector<Slot> old(slots_.empty() ? 16 : 2 * slots_.size());
    old.swap(slots_);
    for (const Slot& slot : old)
        if (slot.key) slots_[place(slot.key)] = slot;
}

std::size_t KeyMap::place(const char* key) const {
    // Texts are allocated, so the lowest bits say nothing.
    std::size_t at = (reinterpret_cast<std::uintptr_t>(key) >> 3) * 0x9e3779b97f4a7c15u >> 32;
    for (;; ++at) {
        const Slot& slot = slots_[at & (slots_.size() - 1)];
        if (!slot.key || slot.key == key) return at & (slots_.size() - 1);
    }
}

} // namespace hachure::script
