#include <hachure/editor/play/report_html.h>
#include <hachure/runtime/assets/file_bytes.h>
#include <hachure/runtime/assets/png_check.h>
#include <hachure/runtime/error.h>

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace hachure::play {
namespace {

constexpr std::string_view replacement = "\xEF\xBF\xBD"; // U+FFFD
constexpr std::uintmax_t max_picture_bytes = std::uintmax_t{64} << 20;

/// How many bytes the character at the start of `text` has; 0 when it is no well-formed UTF-8 (RFC 3629: no overlong
/// forms, no surrogates, nothing beyond U+10FFFF).
std::size_t character_bytes(std::string_view text) {
    const auto at = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned char first = at(0);
    if (first < 0x80) return 1;
    const std::size_t bytes = first < 0xC2 ? 0 : first < 0xE0 ? 2 : first < 0xF0 ? 3 : first < 0xF5 ? 4 : 0;
    if (bytes == 0 || text.size() < bytes) return 0;
    for (std::size_t i = 1; i < bytes; ++i)
        if ((at(i) & 0xC0) != 0x80) return 0;
    if (first == 0xE0 && at(1) < 0xA0) return 0;
    if (first == 0xED && at(1) >= 0xA0) return 0;
    if (first == 0xF0 && at(1) < 0x90) return 0;
    if (first == 0xF4 && at(1) >= 0x90) return 0;
    return bytes;
}

/// Empty for a character that stays as it is.
std::string_view escape_of(char c) {
    switch (c) {
    case '&':
        return "&amp;";
    case '<':
        return "&lt;";
    case '>':
        return "&gt;";
    case '"':
        return "&quot;";
    case '\'':
        return "&#39;";
    case '\t':
    case '\n':
        return {};
    default:
        return static_cast<unsigned char>(c) < 0x20 || c == 0x7F ? replacement : std::string_view{};
    }
}

std::string base64(std::span<const std::byte> bytes) {
    constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t group = 0;
        for (std::size_t j = 0; j < 3; ++j)
            group = group << 8 | (i + j < bytes.size() ? std::to_integer<std::uint32_t>(bytes[i + j]) : 0u);
        for (std::size_t j = 0; j < 4; ++j) text += i + j <= bytes.size() ? digits[group >> (18 - 6 * j) & 63u] : '=';
    }
    return text;
}

struct Png {
    std::vector<std::byte> bytes;
    std::uint32_t width = 0, height = 0;
};

/// Nothing where the file is no whole PNG.
std::optional<Png> read_png(const std::filesystem::path& file) {
    try {
        Png png{assets::read_file_bytes(file, max_picture_bytes)};
        if (!assets::is_png(png.bytes)) return {};
        assets::check_png(file.string(), png.bytes);
        for (std::size_t i = 0; i < 4; ++i) { // the first chunk is IHDR
            png.width = png.width << 8 | std::to_integer<std::uint32_t>(png.bytes[16 + i]);
            png.height = png.height << 8 | std::to_integer<std::uint32_t>(png.bytes[20 + i]);
        }
        return png;
    } catch (const Error&) {
        return {};
    }
}

} // namespace

std::string html_text(std::string_view text) {
    std::string result;
    result.reserve(text.size());
    while (!text.empty()) {
        const std::size_t bytes = character_bytes(text);
        const std::string_view escape = bytes == 0 ? replacement : bytes == 1 ? escape_of(text[0]) : std::string_view{};
        result += escape.empty() ? text.substr(0, bytes) : escape;
        text.remove_prefix(bytes == 0 ? 1 : bytes);
    }
    return result;
}

std::string html_path(const std::filesystem::path& path) { return html_text(path.string()); }

std::string html_number(double value) {
    if (std::isnan(value)) return "n/a";
    if (std::isinf(value)) return value > 0 ? "∞" : "−∞";
    std::string text = fmt::format("{:.4g}", value);
    if (text.front() == '-') text.replace(0, 1, "−");
    return text;
}

std::string html_seconds(double seconds) {
    if (!(seconds < 60.0)) {
        if (!(seconds < 1e9)) return html_number(seconds) + " s";
        const auto whole = std::llround(seconds);
        return fmt::format("{} min {} s", whole / 60, whole % 60);
    }
    return seconds < 0.01 ? "&lt; 0.01 s" : fmt::format("{:.{}f} s", seconds, seconds < 9.995 ? 2 : 1);
}

std::string html_picture(const std::filesystem::path& png, std::string_view description, std::string_view classes) {
    const std::optional<Png> picture = png.empty() ? std::nullopt : read_png(png);
    if (!picture)
        return fmt::format("<div class=\"missing {1}\" role=\"img\" aria-label=\"{0}: missing\">"
                           "<span>{0}</span><em>{2}</em></div>",
                           html_text(description), classes,
                           png.empty() ? "there is none" : "can’t be read: " + html_path(png.filename()));
    return fmt::format("<img class=\"{}\" alt=\"{}\" width=\"{}\" height=\"{}\" decoding=\"async\" draggable=\"false\" "
                       "src=\"data:image/png;base64,{}\">",
                       classes, html_text(description), picture->width, picture->height, base64(picture->bytes));
}

} // namespace hachure::play
