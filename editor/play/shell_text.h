#pragma once

#include <algorithm>
#include <cctype>
#include <string>
#include <string_view>

namespace hachure::play {

/// The text as one word of a shell command.
[[nodiscard]] inline std::string shell_text(std::string_view text) {
    const auto plain = [](char c) {
        return std::isalnum(static_cast<unsigned char>(c)) ||
               std::string_view("/._-+=:,").find(c) != std::string_view::npos;
    };
    if (!text.empty() && std::ranges::all_of(text, plain)) return std::string(text);
    std::string quoted = "'";
    for (const char c : text) c == '\'' ? quoted += "'\\''" : quoted += c;
    return quoted + "'";
}

} // namespace hachure::play
