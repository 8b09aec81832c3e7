#include <hachure/runtime/assets/json_value.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace hachure::assets {

std::string in_quotes(std::string_view text) {
    constexpr std::size_t most = 60;
    return text.size() > most ? fmt::format("\"{}...\"", text.substr(0, most)) : fmt::format("\"{}\"", text);
}

void JsonValue::require_keys(std::initializer_list<std::string_view> keys) const {
    if (!value_->is_object()) fail("this is no object");
    for (const auto& [key, value] : value_->items())
        if (std::ranges::find(keys, key) == keys.end())
            text_->fail(pointer_ + "/" + pointer_token(key),
                        fmt::format("there is no key {} here, but {}", in_quotes(key), fmt::join(keys, ", ")));
}

std::optional<JsonValue> JsonValue::find(std::string_view key) const {
    if (!value_->is_object()) fail("this is no object");
    const auto found = value_->find(key);
    if (found == value_->end()) return std::nullopt;
    return JsonValue(*text_, pointer_ + "/" + pointer_token(key), *found);
}

JsonValue JsonValue::at(std::string_view key) const {
    std::optional<JsonValue> found = find(key);
    if (!found) fail(fmt::format("\"{}\" is missing", key));
    return *std::move(found);
}

std::size_t JsonValue::array_size(std::size_t most) const {
    if (!value_->is_array()) fail("this is no array");
    if (value_->size() > most) fail(fmt::format("{} elements are too many, {} at most", value_->size(), most));
    return value_->size();
}

JsonValue JsonValue::at(std::size_t index) const {
    if (!value_->is_array()) fail("this is no array");
    if (index >= value_->size()) fail(fmt::format("element {} is missing", index));
    return {*text_, fmt::format("{}/{}", pointer_, index), (*value_)[index]};
}

double JsonValue::number(double min, double max) const {
    if (!value_->is_number()) fail("this is no number");
    const double number = value_->get<double>();
    if (!std::isfinite(number)) fail("the number is not finite");
    if (number < min || number > max) fail(fmt::format("{} is outside [{}, {}]", number, min, max));
    return number;
}

bool JsonValue::flag() const {
    if (!value_->is_boolean()) fail("this is neither true nor false");
    return value_->get<bool>();
}

const std::string& JsonValue::string() const {
    if (!value_->is_string()) fail("this is no text");
    return value_->get_ref<const std::string&>();
}

std::size_t JsonValue::option(std::initializer_list<std::string_view> options) const {
    const auto found = std::ranges::find(options, string());
    if (found == options.end()) fail(fmt::format("{} is none of {}", in_quotes(string()), fmt::join(options, ", ")));
    return static_cast<std::size_t>(found - options.begin());
}

} // namespace hachure::assets
