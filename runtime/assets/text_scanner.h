#pragma once

#include <hachure/runtime/error.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace hachure::assets {

/// Reads words and numbers from a text in memory, and says where it stands in faults. It never reads past the end.
/// Blanks are space, tab, carriage return, vertical tab and form feed, so both line endings work.
class TextScanner {
public:
    TextScanner(const std::filesystem::path& file, std::string_view text)
        : file_(file), begin_(text.data()), at_(text.data()), end_(text.data() + text.size()) {}

    [[nodiscard]] bool at_end() const { return at_ == end_; }
    [[nodiscard]] std::size_t offset() const { return static_cast<std::size_t>(at_ - begin_); }
    [[nodiscard]] std::size_t remaining() const { return static_cast<std::size_t>(end_ - at_); }
    [[nodiscard]] char peek() const { return at_ == end_ ? '\0' : *at_; }
    void rewind(std::size_t offset) { at_ = begin_ + offset; }
    void advance(std::size_t count) { at_ += std::min(count, remaining()); }

    void skip_blanks() {
        while (at_ != end_ && is_blank(*at_)) ++at_;
    }

    /// Like skip_blanks, and over a backslash at the end of a line, which continues it.
    void skip_blanks_and_continuations() {
        for (skip_blanks(); at_ != end_ && *at_ == '\\'; skip_blanks()) {
            const char* after = at_ + 1;
            while (after != end_ && is_blank(*after)) ++after;
            if (after == end_ || *after != '\n') return;
            at_ = after + 1;
        }
    }

    /// Over blanks and ends of lines.
    void skip_space() {
        while (at_ != end_ && (is_blank(*at_) || *at_ == '\n')) ++at_;
    }

    /// Over blanks, ends of lines and comments that start with '#'.
    void skip_space_and_comments() {
        for (skip_space(); at_ != end_ && *at_ == '#'; skip_space()) skip_line();
    }

    /// To the start of the next line.
    void skip_line() {
        while (at_ != end_ && *at_ != '\n') ++at_;
        if (at_ != end_) ++at_;
    }

    /// Whether nothing but a comment is left of the line; call it after skipping blanks.
    [[nodiscard]] bool at_line_end() const { return at_ == end_ || *at_ == '\n' || *at_ == '#'; }

    /// Characters up to a blank or the end of the line; empty at one.
    std::string_view word() {
        const char* start = at_;
        while (at_ != end_ && !is_blank(*at_) && *at_ != '\n') ++at_;
        return {start, static_cast<std::size_t>(at_ - start)};
    }

    /// What is left of the line, without the blanks around it; stays before its end.
    std::string_view rest_in_line() {
        skip_blanks();
        const char* start = at_;
        while (at_ != end_ && *at_ != '\n') ++at_;
        const char* stop = at_;
        while (stop != start && is_blank(stop[-1])) --stop;
        return {start, static_cast<std::size_t>(stop - start)};
    }

    /// A whole decimal number. False, without moving, when there is none.
    bool read(std::int64_t& value) {
        const char* start = at_ != end_ && *at_ == '+' ? at_ + 1 : at_;
        const auto [stop, error] = std::from_chars(start, end_, value);
        if (error != std::errc{}) return false;
        at_ = stop;
        return true;
    }

    /// A decimal number, "nan" and "inf" included; beyond the range of float it is infinite or zero. False, without
    /// moving, when there is none.
    bool read(float& value) {
        const char* start = at_ != end_ && *at_ == '+' ? at_ + 1 : at_;
        auto [stop, error] = std::from_chars(start, end_, value);
        if (error == std::errc::result_out_of_range) {
            double wide = 0.0;
            if (std::from_chars(start, end_, wide).ec != std::errc{}) wide = is_tiny(start, stop) ? 0.0 : HUGE_VAL;
            value = static_cast<float>(wide);
        } else if (error != std::errc{}) {
            return false;
        }
        at_ = stop;
        return true;
    }

    /// Whether a number ends here, and not in the middle of a word.
    [[nodiscard]] bool at_word_end() const { return at_ == end_ || is_blank(*at_) || *at_ == '\n'; }

    /// hachure::Error of this file, at the current line or that of `offset`.
    [[noreturn]] void fail(std::string_view fault) const { fail_at(fault, offset()); }
    [[noreturn]] void fail_at(std::string_view fault, std::size_t offset) const {
        const auto line =
            1 + std::count(begin_, begin_ + std::min(offset, static_cast<std::size_t>(end_ - begin_)), '\n');
        throw Error(file_.string(), fault, "line " + std::to_string(line));
    }

    static bool is_blank(char c) { return c == ' ' || (c >= '\t' && c <= '\r' && c != '\n'); }

private:
    /// Of a number out of double's range: whether its exponent is negative.
    static bool is_tiny(const char* start, const char* stop) {
        const std::string_view number(start, static_cast<std::size_t>(stop - start));
        const std::size_t e = number.find_first_of("eE");
        return e == std::string_view::npos
                   ? number.starts_with("0.") || number.starts_with("-0.") || number.starts_with('.')
                   : e + 1 < number.size() && number[e + 1] == '-';
    }

    const std::filesystem::path& file_;
    const char* begin_;
    const char* at_;
    const char* end_;
};

} // namespace hachure::assets
