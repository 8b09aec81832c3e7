#include <hachure/runtime/assets/json_place.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <charconv>
#include <optional>

namespace hachure::assets {
namespace {

/// Walks over a document token by token, without keeping anything.
class Walk {
public:
    Walk(std::string_view text, std::size_t at) : text_(text), at_(at) { skip_space(); }

    std::size_t at() const { return at_; }
    bool is(char c) const { return at_ < text_.size() && text_[at_] == c; }

    void skip_space() {
        while (at_ < text_.size() && std::string_view(" \t\r\n").find(text_[at_]) != std::string_view::npos) ++at_;
    }

    /// Past the character, whatever it is, and the space behind it.
    void step() {
        at_ = std::min(at_ + 1, text_.size());
        skip_space();
    }

    /// Past a string; returns it with its quotes.
    std::string_view string() {
        const std::size_t begin = at_++;
        while (at_ < text_.size() && text_[at_] != '"') at_ += text_[at_] == '\\' ? 2 : 1;
        at_ = std::min(at_ + 1, text_.size());
        const std::string_view result = text_.substr(begin, at_ - begin);
        skip_space();
        return result;
    }

    /// Past a value, up to the comma or bracket behind it.
    void value() {
        int depth = 0;
        while (at_ < text_.size()) {
            const char c = text_[at_];
            if (depth == 0 && (c == ',' || c == ']' || c == '}')) return;
            if (c == '"') {
                string();
                continue;
            }
            if (c == '[' || c == '{') ++depth;
            if (c == ']' || c == '}') --depth;
            ++at_;
        }
    }

private:
    std::string_view text_;
    std::size_t at_;
};

bool is_key(std::string_view quoted, std::string_view key) {
    if (quoted.find('\\') == std::string_view::npos)
        return quoted.size() == key.size() + 2 && quoted.substr(1, key.size()) == key;
    const auto decoded = nlohmann::json::parse(quoted, nullptr, false);
    return decoded.is_string() && decoded.get_ref<const std::string&>() == key;
}

/// Steps over the members of the object that the walk stands at until one has the key for the n-th time; the walk
/// stands at its value then. Returns where the key stands.
std::optional<std::size_t> find_member(Walk& walk, std::string_view key, int n) {
    walk.step();
    while (walk.is('"')) {
        const std::size_t at = walk.at();
        const bool found = is_key(walk.string(), key);
        if (!walk.is(':')) return {};
        walk.step();
        if (found && --n == 0) return at;
        walk.value();
        if (!walk.is(',')) return {};
        walk.step();
    }
    return {};
}

bool find_element(Walk& walk, std::string_view token) {
    std::size_t index = 0;
    const auto [end, error] = std::from_chars(token.data(), token.data() + token.size(), index);
    if (error != std::errc() || end != token.data() + token.size()) return false;
    walk.step();
    for (; index > 0; --index) {
        walk.value();
        if (!walk.is(',')) return false;
        walk.step();
    }
    return !walk.is(']');
}

std::string unescaped(std::string_view token) {
    std::string result;
    for (std::size_t i = 0; i < token.size(); ++i) {
        const bool escape = token[i] == '~' && i + 1 < token.size() && (token[i + 1] == '0' || token[i + 1] == '1');
        result += escape ? (token[++i] == '1' ? '/' : '~') : token[i];
    }
    return result;
}

constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";

} // namespace

std::string line_and_column(std::string_view text, std::size_t offset) {
    const std::string_view before = text.substr(0, offset);
    const std::size_t line_feed = before.rfind('\n');
    std::string_view line = before.substr(line_feed == std::string_view::npos ? 0 : line_feed + 1);
    if (line.starts_with(byte_order_mark) && line.data() == text.data()) line.remove_prefix(byte_order_mark.size());
    const auto begins_character = [](char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; };
    return fmt::format("line {}, column {}", std::ranges::count(before, '\n') + 1,
                       std::ranges::count_if(line, begins_character) + 1);
}

std::size_t offset_of(std::string_view text, std::string_view pointer) {
    Walk walk(text, text.starts_with(byte_order_mark) ? byte_order_mark.size() : 0);
    std::size_t found = walk.at();
    while (!pointer.empty()) {
        pointer.remove_prefix(1);
        const std::string token = unescaped(pointer.substr(0, pointer.find('/')));
        pointer.remove_prefix(std::min(pointer.find('/'), pointer.size()));
        const bool there =
            walk.is('{') ? find_member(walk, token, 1).has_value() : walk.is('[') && find_element(walk, token);
        if (!there) break;
        found = walk.at();
    }
    return found;
}

std::size_t offset_of_second_key(std::string_view text, std::size_t offset, std::string_view key) {
    Walk walk(text, offset);
    return walk.is('{') ? find_member(walk, key, 2).value_or(offset) : offset;
}

std::string pointer_token(std::string_view key) {
    std::string token;
    for (const char c : key) token += c == '~' ? "~0" : c == '/' ? "~1" : std::string(1, c);
    return token;
}

} // namespace hachure::assets
