#pragma once

#include <hachure/runtime/assets/json_place.h>
#include <hachure/runtime/assets/json_text.h>

#include <nlohmann/json.hpp>

#include <cstddef>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>

namespace hachure::assets {

/// A value of a JsonText with its pointer, for readers: each question is answered, or throws Error with the line and
/// column of what is wrong. The text outlives it.
class JsonValue {
public:
    /// `value` is what `pointer` leads to in `text`.
    JsonValue(const JsonText& text, std::string pointer, const nlohmann::json& value)
        : text_(&text), pointer_(std::move(pointer)), value_(&value) {}
    /// The whole document.
    explicit JsonValue(const JsonText& text) : JsonValue(text, {}, text.root()) {}

    [[nodiscard]] const nlohmann::json& json() const { return *value_; }
    [[nodiscard]] const std::string& pointer() const { return pointer_; }
    [[nodiscard]] const JsonText& text() const { return *text_; }
    /// Where it stands, for people.
    [[nodiscard]] std::string where() const { return text_->where(pointer_); }
    [[noreturn]] void fail(std::string_view fault) const { text_->fail(pointer_, fault); }

    /// Asks for an object that has no keys but these; one that it has besides is named.
    void require_keys(std::initializer_list<std::string_view> keys) const;
    /// The value of a key of an object; none when it is absent.
    [[nodiscard]] std::optional<JsonValue> find(std::string_view key) const;
    /// The same, which must be there.
    [[nodiscard]] JsonValue at(std::string_view key) const;

    /// How many elements an array has, which has at most `most`.
    [[nodiscard]] std::size_t array_size(std::size_t most) const;
    /// Of an array.
    [[nodiscard]] JsonValue at(std::size_t index) const;

    /// A finite number in [min, max].
    [[nodiscard]] double number(double min, double max) const;
    [[nodiscard]] bool flag() const;
    [[nodiscard]] const std::string& string() const;
    /// The place of a string among these.
    [[nodiscard]] std::size_t option(std::initializer_list<std::string_view> options) const;

private:
    const JsonText* text_;
    std::string pointer_;
    const nlohmann::json* value_;
};

/// A text of a file, for a message: what is long is cut.
[[nodiscard]] std::string in_quotes(std::string_view text);

} // namespace hachure::assets
