#pragma once

#include <cstddef>

struct lua_State;

namespace hachure::script {

/// Matches texts with the patterns of Lua. The standard library does so without ever looking up, and some patterns take
/// longer than the universe lasts; here each step is charged to the script.
///
/// Follows lstrlib.c of Lua 5.4 (Copyright 1994-2022 Lua.org, PUC-Rio; MIT licence), so that all patterns mean the
/// same.
class TextPattern {
public:
    static constexpr int most_captures = 32;

    /// Texts hold as long as the matcher. `pattern` is without its anchor.
    TextPattern(lua_State* state, const char* text, std::size_t text_size, const char* pattern,
                std::size_t pattern_size);

    /// Matches at `at` exactly: the end of the match, or null. Raises errors of Lua for malformed patterns.
    const char* match(const char* at);

    /// Pushes capture `index`, from 0; with none in the pattern, capture 0 is the match itself.
    void push_capture(int index, const char* begin, const char* end);

    /// Pushes all captures, or the match when there are none and `begin` is not null; how many they are.
    int push_captures(const char* begin, const char* end);

    /// Counts what was done since the last call.
    void settle();

private:
    struct Capture {
        const char* begin;
        std::ptrdiff_t size; ///< or one of the two below
    };
    static constexpr std::ptrdiff_t unfinished = -1, position = -2;

    const char* match(const char* at, const char* pattern);
    const char* match_default(const char*& at, const char*& pattern, bool& again);
    const char* match_balance(const char* at, const char* pattern);
    const char* match_capture(const char* at, int letter);
    const char* match_frontier(const char*& at, const char*& pattern, bool& again);
    const char* expand_most(const char* at, const char* pattern, const char* pattern_end);
    const char* expand_least(const char* at, const char* pattern, const char* pattern_end);
    const char* start_capture(const char* at, const char* pattern, std::ptrdiff_t what);
    const char* end_capture(const char* at, const char* pattern);
    [[nodiscard]] const char* class_end(const char* pattern) const;
    [[nodiscard]] bool matches_one(const char* at, const char* pattern, const char* pattern_end);
    [[nodiscard]] bool matches_set(int c, const char* pattern, const char* last);
    [[nodiscard]] int checked_capture(int letter) const;
    [[nodiscard]] int capture_to_close() const;
    void count();

    lua_State* state_;
    const char* text_;
    const char* text_end_;
    const char* pattern_;
    const char* pattern_end_;
    int depth_ = 0;
    int level_ = 0; ///< captures so far
    int steps_ = 0; ///< not charged yet
    Capture captures_[most_captures];
};

/// string.find, match, gmatch and gsub with it, into the table on top of the stack.
void open_patterns(lua_State* state);

} // namespace hachure::script
