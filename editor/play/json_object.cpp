#include <hachure/editor/play/json_object.h>
#include <hachure/runtime/assets/json_place.h>

#include <fmt/format.h>

#include <cmath>

namespace hachure::play {

std::string child_pointer(std::string_view pointer, std::string_view key) {
    return fmt::format("{}/{}", pointer, assets::pointer_token(key));
}

std::string child_pointer(std::string_view pointer, std::size_t index) {
    return child_pointer(pointer, std::to_string(index));
}

JsonObject::JsonObject(const assets::JsonText& text, std::string pointer, const nlohmann::json& value)
    : text_(&text), pointer_(std::move(pointer)), value_(&value) {
    if (!value.is_object()) text.fail(pointer_, "is no object");
}

std::string JsonObject::pointer(std::string_view key) const { return child_pointer(pointer_, key); }

const nlohmann::json* JsonObject::find(const std::string& key) {
    known_.insert(key);
    const auto found = value_->find(key);
    return found == value_->end() ? nullptr : &*found;
}

const nlohmann::json& JsonObject::at(const std::string& key) {
    const nlohmann::json* found = find(key);
    if (!found) text_->fail(pointer_, "'" + key + "' is missing");
    return *found;
}

std::string JsonObject::text(const std::string& key) {
    const nlohmann::json& value = at(key);
    if (!value.is_string() || value.get_ref<const std::string&>().empty()) fail(key, key + " is no text, or empty");
    return value.get<std::string>();
}

std::string JsonObject::text(const std::string& key, std::string fallback) {
    return find(key) ? text(key) : std::move(fallback);
}

double JsonObject::number(const std::string& key, double min, double max) {
    const nlohmann::json& value = at(key);
    const double number = value.is_number() ? value.get<double>() : NAN;
    if (!(number >= min && number <= max)) fail(key, fmt::format("{} is no number from {} to {}", key, min, max));
    return number;
}

double JsonObject::number(const std::string& key, double min, double max, double fallback) {
    return find(key) ? number(key, min, max) : fallback;
}

std::int64_t JsonObject::integer(const std::string& key, std::int64_t min, std::int64_t max) {
    const nlohmann::json& value = at(key);
    // An unsigned value beyond int64 is beyond every maximum, too.
    const bool fits =
        value.is_number_integer() &&
        (!value.is_number_unsigned() || value.get<std::uint64_t>() <= static_cast<std::uint64_t>(INT64_MAX));
    if (!fits || value.get<std::int64_t>() < min || value.get<std::int64_t>() > max)
        fail(key, fmt::format("{} is no whole number from {} to {}", key, min, max));
    return value.get<std::int64_t>();
}

std::int64_t JsonObject::integer(const std::string& key, std::int64_t min, std::int64_t max, std::int64_t fallback) {
    return find(key) ? integer(key, min, max) : fallback;
}

std::vector<std::string> JsonObject::texts(const std::string& key) {
    std::vector<std::string> result;
    const nlohmann::json* value = find(key);
    if (!value) return result;
    if (!value->is_array()) fail(key, key + " is no array of texts");
    for (std::size_t i = 0; i < value->size(); ++i) {
        if (!(*value)[i].is_string()) text_->fail(child_pointer(pointer(key), i), "is no text");
        result.push_back((*value)[i].get<std::string>());
    }
    return result;
}

void JsonObject::finish() const {
    for (const auto& [key, value] : value_->items())
        if (!known_.contains(key)) fail(key, "'" + key + "' is unknown here");
}

} // namespace hachure::play
