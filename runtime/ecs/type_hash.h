#pragma once

#include <cstdint>
#include <string_view>

namespace hachure {

/// FNV-1a, 64 bits: the same for a name on every machine and in every build. Files and libraries know a type by the
/// hash of its registered name.
constexpr std::uint64_t type_hash(std::string_view name) {
    std::uint64_t hash = 0xcbf2'9ce4'8422'2325u;
    for (const char c : name) {
        hash ^= static_cast<unsigned char>(c);
        hash *= 0x100'0000'01b3u;
    }
    return hash;
}

} // namespace hachure
