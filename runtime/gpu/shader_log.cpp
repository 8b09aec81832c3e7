#include <hachure/runtime/gpu/shader_source.h>

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdint>

namespace hachure::gpu {
namespace {

/// Takes a number off the front.
std::optional<std::size_t> take_number(std::string_view& text) {
    std::size_t number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc()) return std::nullopt;
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    return number;
}

bool take(std::string_view& text, std::string_view prefix) {
    if (!text.starts_with(prefix)) return false;
    text.remove_prefix(prefix.size());
    return true;
}

struct Message {
    std::size_t line = 0; ///< of the text given to the compiler, from 1
    std::string_view text;
};

// STRING is the source-string number, which is always 0 here: a shader is handed over as one string.

/// "STRING:LINE(COLUMN): text"
std::optional<Message> parse_mesa(std::string_view line) {
    if (!take_number(line) || !take(line, ":")) return std::nullopt;
    const auto number = take_number(line);
    if (!number || !take(line, "(") || !take_number(line) || !take(line, "): ")) return std::nullopt;
    return Message{*number, line};
}

/// "STRING(LINE) : text"
std::optional<Message> parse_nvidia(std::string_view line) {
    if (!take_number(line) || !take(line, "(")) return std::nullopt;
    const auto number = take_number(line);
    if (!number || !take(line, ") : ")) return std::nullopt;
    return Message{*number, line};
}

/// "ERROR: STRING:LINE: text"
std::optional<Message> parse_glslang(std::string_view line) {
    if (!take(line, "ERROR: ") && !take(line, "WARNING: ")) return std::nullopt;
    if (!take_number(line) || !take(line, ":")) return std::nullopt;
    const auto number = take_number(line);
    if (!number || !take(line, ": ")) return std::nullopt;
    return Message{*number, line};
}

std::string readable_line(std::string_view line, const ShaderSource& source) {
    auto message = parse_mesa(line);
    if (!message) message = parse_nvidia(line);
    std::string_view kind;
    if (!message) {
        message = parse_glslang(line);
        kind = line.starts_with("ERROR") ? "error: " : "warning: ";
    }
    if (!message || message->line == 0 || message->line > source.lines.size()) return std::string(line);
    const ShaderSource::Line& place = source.lines[message->line - 1];
    return fmt::format("{}:{}: {}{}", source.files[place.file], place.number, kind, message->text);
}

} // namespace

std::string readable_shader_log(std::string_view log, const ShaderSource& source) {
    std::string readable;
    while (!log.empty()) {
        const std::size_t end = std::min(log.find('\n'), log.size());
        std::string_view line = log.substr(0, end);
        log.remove_prefix(std::min(end + 1, log.size()));
        while (!line.empty() && (line.back() == '\r' || line.back() == '\0' || line.back() == ' '))
            line.remove_suffix(1);
        if (line.empty()) continue;
        if (!readable.empty()) readable += '\n';
        readable += readable_line(line, source);
    }
    return readable;
}

} // namespace hachure::gpu
