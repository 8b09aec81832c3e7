#include <hachure/runtime/assert.h>
#include <hachure/runtime/ecs/field_text.h>
#include <hachure/runtime/error.h>

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <system_error>

namespace hachure {
namespace {

constexpr std::string_view blanks = " \t\r\n";

std::string_view trimmed(std::string_view text) {
    const std::size_t first = text.find_first_not_of(blanks);
    return first == text.npos ? std::string_view{} : text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

[[noreturn]] void fail(const FieldInfo& field, std::string_view text, std::string_view fault) {
    const std::string_view dots = text.size() > 60 ? "..." : "";
    throw Error(field.path, fmt::format("\"{}{}\" {}", text.substr(0, 60), dots, fault));
}

template <class Number> Number parse_number(const FieldInfo& field, std::string_view text) {
    Number number{};
    const char* const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, number);
    if (error == std::errc::result_out_of_range && stop == end) fail(field, text, "is too large or too small");
    if (error != std::errc{} || stop != end)
        fail(field, text, std::is_integral_v<Number> ? "is no integer" : "is no number");
    return number;
}

/// Takes the next number off `text`: up to a comma, or to blanks.
std::string_view take_number(std::string_view& text) {
    const std::size_t end = text.find_first_of(" \t\r\n,");
    const std::string_view number = text.substr(0, end);
    text = end == text.npos ? std::string_view{} : trimmed(text.substr(end));
    // "1 , 2": the comma belongs to the blanks before it.
    if (end != std::string_view::npos && !text.empty() && text.front() == ',') text = trimmed(text.substr(1));
    return number;
}

template <std::size_t n> std::array<float, n> parse_numbers(const FieldInfo& field, std::string_view text) {
    std::array<float, n> numbers{};
    std::size_t count = 0;
    for (std::string_view rest = text; !rest.empty(); ++count) {
        const float number = parse_number<float>(field, take_number(rest));
        if (count < n) numbers[count] = number;
    }
    if (count != n) fail(field, text, fmt::format("has {} numbers instead of {}", count, n));
    return numbers;
}

/// IEC 61966-2-1.
float linear_from_srgb(std::uint32_t byte) {
    const double encoded = byte / 255.0;
    return static_cast<float>(encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4));
}

glm::vec4 parse_hex_color(const FieldInfo& field, std::string_view text, bool with_alpha) {
    const std::string_view digits = text.substr(1);
    const bool has_alpha = digits.size() == 8 && with_alpha;
    std::uint32_t bytes = 0;
    const auto [stop, error] = std::from_chars(digits.data(), digits.data() + digits.size(), bytes, 16);
    if ((digits.size() != 6 && !has_alpha) || error != std::errc{} || stop != digits.data() + digits.size())
        fail(field, text, with_alpha ? "is neither #rrggbb nor #rrggbbaa" : "is not #rrggbb");
    if (!has_alpha) bytes = bytes << 8 | 0xff;
    return {linear_from_srgb(bytes >> 24), linear_from_srgb(bytes >> 16 & 0xff), linear_from_srgb(bytes >> 8 & 0xff),
            static_cast<float>(bytes & 0xff) / 255.0f};
}

/// As to_string(Entity) writes it.
Entity parse_entity(const FieldInfo& field, std::string_view text) {
    if (text == "null") return Entity::null;
    const std::size_t v = text.find('v');
    if (v == text.npos) fail(field, text, "is neither null nor a handle such as 12v3");
    return {parse_number<std::uint32_t>(field, text.substr(0, v)),
            parse_number<std::uint32_t>(field, text.substr(v + 1))};
}

/// Reads the alternative of FieldValue that `Value` is.
struct Parse {
    const FieldInfo& field;
    std::string_view text; ///< as given
    std::string_view bare = trimmed(text);

    FieldValue operator()(bool) const {
        if (bare != "true" && bare != "false") fail(field, bare, "is neither true nor false");
        return bare == "true";
    }
    FieldValue operator()(std::int64_t) const { return parse_number<std::int64_t>(field, bare); }
    FieldValue operator()(std::uint64_t) const { return parse_number<std::uint64_t>(field, bare); }
    FieldValue operator()(double) const {
        // A float is read as such: rounding twice, through double, can miss the nearest one.
        return field.bits == 32 ? double{parse_number<float>(field, bare)} : parse_number<double>(field, bare);
    }
    FieldValue operator()(const glm::vec2&) const {
        const auto [x, y] = parse_numbers<2>(field, bare);
        return glm::vec2(x, y);
    }
    FieldValue operator()(const glm::vec3&) const {
        if (is_hex()) return glm::vec3(parse_hex_color(field, bare, false));
        const auto [x, y, z] = parse_numbers<3>(field, bare);
        return glm::vec3(x, y, z);
    }
    FieldValue operator()(const glm::vec4&) const {
        if (is_hex()) return parse_hex_color(field, bare, true);
        const auto [x, y, z, w] = parse_numbers<4>(field, bare);
        return glm::vec4(x, y, z, w);
    }
    FieldValue operator()(const glm::quat&) const {
        const auto [x, y, z, w] = parse_numbers<4>(field, bare);
        return glm::quat(w, x, y, z);
    }
    FieldValue operator()(Entity) const { return parse_entity(field, bare); }
    FieldValue operator()(const std::string&) const {
        return std::string(field.kind == FieldKind::enumeration ? bare : text);
    }

    bool is_hex() const { return field.kind == FieldKind::color && bare.starts_with('#'); }
};

struct Format {
    const FieldInfo& field;

    std::string operator()(bool value) const { return value ? "true" : "false"; }
    std::string operator()(std::int64_t value) const { return fmt::format("{}", value); }
    std::string operator()(std::uint64_t value) const { return fmt::format("{}", value); }
    std::string operator()(double value) const {
        return field.bits == 32 ? fmt::format("{}", static_cast<float>(value)) : fmt::format("{}", value);
    }
    std::string operator()(const glm::vec2& v) const { return fmt::format("{} {}", v.x, v.y); }
    std::string operator()(const glm::vec3& v) const { return fmt::format("{} {} {}", v.x, v.y, v.z); }
    std::string operator()(const glm::vec4& v) const { return fmt::format("{} {} {} {}", v.x, v.y, v.z, v.w); }
    std::string operator()(const glm::quat& q) const { return fmt::format("{} {} {} {}", q.x, q.y, q.z, q.w); }
    std::string operator()(const std::string& value) const { return value; }
    std::string operator()(Entity value) const { return to_string(value); }
};

} // namespace

FieldValue parse_field(const FieldInfo& field, std::string_view text) {
    FieldValue value = std::visit(Parse{field, text}, field.default_value);
    if (const std::string fault = field.fault(value); !fault.empty()) throw Error(field.path, fault);
    return value;
}

std::string format_field(const FieldInfo& field, const FieldValue& value) {
    HACHURE_ASSERT(value.index() == field.default_value.index(), "a value is of its field's kind");
    return std::visit(Format{field}, value);
}

} // namespace hachure
