#include <hachure/systems/script/lua_binding.h>
#include <hachure/systems/script/script_api.h>
#include <hachure/systems/script/script_context.h>
#include <hachure/systems/script/script_random.h>

#include <lua5.4/lua.hpp>

namespace hachure::script {
namespace {

__extension__ using Wide = unsigned __int128;

/// random(): in [0, 1). random(n): a whole number from 1 to n. random(a, b): a whole number from a to b.
int random(lua_State* state) {
    Context& context = context_of(state);
    const std::uint64_t bits = random_bits(context.random_key, (*context.random_calls)++);
    const int count = lua_gettop(state);
    if (count == 0) {
        lua_pushnumber(state, static_cast<double>(bits >> 11) * 0x1p-53);
        return 1;
    }
    const lua_Integer low = count == 1 ? 1 : luaL_checkinteger(state, 1);
    const lua_Integer high = luaL_checkinteger(state, count == 1 ? 1 : 2);
    if (low > high) return luaL_argerror(state, count == 1 ? 1 : 2, "there is no number in that interval");
    const auto range = static_cast<std::uint64_t>(high) - static_cast<std::uint64_t>(low);
    // The upper half of the product: as even as 64 bits allow, and without a loop.
    const std::uint64_t pick =
        range == ~std::uint64_t{0} ? bits : static_cast<std::uint64_t>(static_cast<Wide>(bits) * (range + 1) >> 64);
    lua_pushinteger(state, static_cast<lua_Integer>(static_cast<std::uint64_t>(low) + pick));
    return 1;
}

} // namespace

void open_random(lua_State* state) {
    lua_pushcfunction(state, random);
    lua_setfield(state, -2, "random");
}

} // namespace hachure::script
