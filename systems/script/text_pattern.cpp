#include <hachure/systems/script/lua_machine.h>
#include <hachure/systems/script/text_pattern.h>

#include <lua5.4/lua.hpp>

#include <cctype>
#include <cstring>

namespace hachure::script {
namespace {

constexpr char escape = '%';
constexpr int deepest = 200;
constexpr int settled_each = 1024;

int byte(const char* at) { return static_cast<unsigned char>(*at); }

/// Whether `c` is of the class that the letter names: "%a", and "%A" for all others.
bool is_of_class(int c, int letter) {
    bool result = false;
    switch (std::tolower(letter)) {
    case 'a':
        result = std::isalpha(c);
        break;
    case 'c':
        result = std::iscntrl(c);
        break;
    case 'd':
        result = std::isdigit(c);
        break;
    case 'g':
        result = std::isgraph(c);
        break;
    case 'l':
        result = std::islower(c);
        break;
    case 'p':
        result = std::ispunct(c);
        break;
    case 's':
        result = std::isspace(c);
        break;
    case 'u':
        result = std::isupper(c);
        break;
    case 'w':
        result = std::isalnum(c);
        break;
    case 'x':
        result = std::isxdigit(c);
        break;
    default:
        return letter == c;
    }
    return std::isupper(letter) ? !result : result;
}

} // namespace

TextPattern::TextPattern(lua_State* state, const char* text, std::size_t text_size, const char* pattern,
                         std::size_t pattern_size)
    : state_(state), text_(text), text_end_(text + text_size), pattern_(pattern), pattern_end_(pattern + pattern_size) {
}

void TextPattern::settle() {
    const int steps = steps_;
    steps_ = 0;
    Machine::of(state_).charge(state_, steps);
}

void TextPattern::count() {
    if (++steps_ >= settled_each) settle();
}

const char* TextPattern::match(const char* at) {
    level_ = 0;
    depth_ = 0;
    return match(at, pattern_);
}

const char* TextPattern::match(const char* at, const char* pattern) {
    if (++depth_ > deepest) luaL_error(state_, "pattern too complex");
    const char* result = at;
    for (bool again = true; again;) {
        again = false;
        count();
        result = at;
        if (pattern == pattern_end_) break;
        switch (*pattern) {
        case '(':
            result = pattern + 1 < pattern_end_ && pattern[1] == ')' ? start_capture(at, pattern + 2, position)
                                                                     : start_capture(at, pattern + 1, unfinished);
            break;
        case ')':
            result = end_capture(at, pattern + 1);
            break;
        case '$':
            if (pattern + 1 != pattern_end_)
                result = match_default(at, pattern, again);
            else
                result = at == text_end_ ? at : nullptr;
            break;
        case escape: {
            const char next = pattern + 1 < pattern_end_ ? pattern[1] : '\0';
            if (next == 'b') {
                result = at = match_balance(at, pattern + 2);
                again = at != nullptr;
                pattern += again ? 4 : 0;
            } else if (next == 'f') {
                result = match_frontier(at, pattern, again);
            } else if (std::isdigit(static_cast<unsigned char>(next))) {
                result = at = match_capture(at, byte(pattern + 1));
                again = at != nullptr;
                pattern += again ? 2 : 0;
            } else {
                result = match_default(at, pattern, again);
            }
            break;
        }
        default:
            result = match_default(at, pattern, again);
        }
    }
    --depth_;
    return result;
}

/// One class with what may follow it: '?', '+', '*', '-'. Moves on and sets `again` where that needs no recursion.
const char* TextPattern::match_default(const char*& at, const char*& pattern, bool& again) {
    const char* const end = class_end(pattern);
    const char repeat = end < pattern_end_ ? *end : '\0';
    const bool one = matches_one(at, pattern, end);
    if (!one && repeat != '*' && repeat != '?' && repeat != '-') return nullptr;
    switch (repeat) {
    case '?':
        if (one)
            if (const char* const result = match(at + 1, end + 1)) return result;
        pattern = end + 1;
        break;
    case '+':
        return expand_most(at + 1, pattern, end);
    case '*':
        return expand_most(at, pattern, end);
    case '-':
        return expand_least(at, pattern, end);
    default:
        ++at;
        pattern = end;
    }
    again = true;
    return at;
}

/// "%bxy". Here `pattern` is past "%b".
const char* TextPattern::match_balance(const char* at, const char* pattern) {
    if (pattern + 1 >= pattern_end_) luaL_error(state_, "malformed pattern (missing arguments to '%%b')");
    if (at >= text_end_ || *at != *pattern) return nullptr;
    const char open = *pattern, close = pattern[1];
    int level = 1;
    while (++at < text_end_) {
        count();
        if (*at == close) {
            if (--level == 0) return at + 1;
        } else if (*at == open) {
            ++level;
        }
    }
    return nullptr;
}

/// "%f[set]": between one that is not of the set and one that is.
const char* TextPattern::match_frontier(const char*& at, const char*& pattern, bool& again) {
    const char* const set = pattern + 2;
    if (set >= pattern_end_ || *set != '[') luaL_error(state_, "missing '[' after '%%f' in pattern");
    const char* const end = class_end(set);
    const int before = at == text_ ? '\0' : byte(at - 1), now = at == text_end_ ? '\0' : byte(at);
    if (matches_set(before, set, end - 1) || !matches_set(now, set, end - 1)) return nullptr;
    pattern = end;
    again = true;
    return at;
}

/// "%1": what a capture holds.
const char* TextPattern::match_capture(const char* at, int letter) {
    const Capture& capture = captures_[checked_capture(letter)];
    const auto size = static_cast<std::size_t>(capture.size);
    steps_ += static_cast<int>(size / 16);
    if (static_cast<std::size_t>(text_end_ - at) < size || std::memcmp(capture.begin, at, size) != 0) return nullptr;
    return at + size;
}

const char* TextPattern::expand_most(const char* at, const char* pattern, const char* pattern_end) {
    std::ptrdiff_t i = 0;
    for (; matches_one(at + i, pattern, pattern_end); ++i) count();
    for (; i >= 0; --i)
        if (const char* const result = match(at + i, pattern_end + 1)) return result;
    return nullptr;
}

const char* TextPattern::expand_least(const char* at, const char* pattern, const char* pattern_end) {
    for (;; ++at) {
        if (const char* const result = match(at, pattern_end + 1)) return result;
        if (!matches_one(at, pattern, pattern_end)) return nullptr;
    }
}

const char* TextPattern::start_capture(const char* at, const char* pattern, std::ptrdiff_t what) {
    if (level_ >= most_captures) luaL_error(state_, "too many captures");
    captures_[level_] = {at, what};
    ++level_;
    const char* const result = match(at, pattern);
    if (!result) --level_;
    return result;
}

const char* TextPattern::end_capture(const char* at, const char* pattern) {
    const int level = capture_to_close();
    captures_[level].size = at - captures_[level].begin;
    const char* const result = match(at, pattern);
    if (!result) captures_[level].size = unfinished;
    return result;
}

const char* TextPattern::class_end(const char* pattern) const {
    if (*pattern == escape) {
        if (pattern + 1 >= pattern_end_) luaL_error(state_, "malformed pattern (ends with '%%')");
        return pattern + 2;
    }
    if (*pattern++ != '[') return pattern;
    if (pattern < pattern_end_ && *pattern == '^') ++pattern;
    do { // the first one is no end, even if it is a ']'
        if (pattern >= pattern_end_) luaL_error(state_, "malformed pattern (missing ']')");
        if (*pattern++ == escape) ++pattern;
    } while (pattern >= pattern_end_ || *pattern != ']');
    return pattern + 1;
}

bool TextPattern::matches_one(const char* at, const char* pattern, const char* pattern_end) {
    if (at >= text_end_) return false;
    switch (*pattern) {
    case '.':
        return true;
    case escape:
        return is_of_class(byte(at), byte(pattern + 1));
    case '[':
        return matches_set(byte(at), pattern, pattern_end - 1);
    default:
        return *pattern == *at;
    }
}

/// `last` is the closing bracket.
bool TextPattern::matches_set(int c, const char* pattern, const char* last) {
    bool found = true;
    if (pattern[1] == '^') {
        found = false;
        ++pattern;
    }
    while (++pattern < last) {
        count();
        if (*pattern == escape) {
            ++pattern;
            if (is_of_class(c, byte(pattern))) return found;
        } else if (pattern[1] == '-' && pattern + 2 < last) {
            pattern += 2;
            if (byte(pattern - 2) <= c && c <= byte(pattern)) return found;
        } else if (byte(pattern) == c) {
            return found;
        }
    }
    return !found;
}

int TextPattern::checked_capture(int letter) const {
    const int index = letter - '1';
    if (index < 0 || index >= level_ || captures_[index].size == unfinished)
        luaL_error(state_, "invalid capture index %%%d in pattern", index + 1);
    if (captures_[index].size == position) luaL_error(state_, "a position is no text to match");
    return index;
}

int TextPattern::capture_to_close() const {
    for (int level = level_ - 1; level >= 0; --level)
        if (captures_[level].size == unfinished) return level;
    luaL_error(state_, "invalid pattern capture");
    return 0;
}

void TextPattern::push_capture(int index, const char* begin, const char* end) {
    if (index >= level_) {
        if (index != 0) luaL_error(state_, "invalid capture index %%%d", index + 1);
        lua_pushlstring(state_, begin, static_cast<std::size_t>(end - begin));
        return;
    }
    const Capture& capture = captures_[index];
    if (capture.size == unfinished) luaL_error(state_, "unfinished capture");
    if (capture.size == position)
        lua_pushinteger(state_, capture.begin - text_ + 1);
    else
        lua_pushlstring(state_, capture.begin, static_cast<std::size_t>(capture.size));
}

int TextPattern::push_captures(const char* begin, const char* end) {
    const int count = level_ == 0 && begin ? 1 : level_;
    luaL_checkstack(state_, count, "too many captures");
    for (int i = 0; i < count; ++i) push_capture(i, begin, end);
    return count;
}

} // namespace hachure::script
