#include <hachure/runtime/assets/gltf_json.h>
#include <hachure/runtime/assets/json_place.h>
#include <hachure/runtime/error.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace hachure::assets {
namespace {

using nlohmann::json;

constexpr std::size_t max_depth = 128;
constexpr std::size_t max_objects = 500'000;
constexpr std::size_t max_values = 4'000'000;

// One pass over the brackets and commas outside strings, before anything is allocated or recursed into.
void check_json_size(std::string_view text, const std::string& file) {
    std::size_t depth = 0, objects = 0, values = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        switch (text[i]) {
        case '"':
            for (++i; i < text.size() && text[i] != '"'; ++i)
                if (text[i] == '\\') ++i;
            break;
        case '{':
            ++objects;
            [[fallthrough]];
        case '[':
            ++values;
            if (++depth > max_depth) throw Error(file, "has JSON nested too deeply", fmt::format("byte {}", i));
            break;
        case '}':
        case ']':
            depth -= depth > 0 ? 1 : 0;
            break;
        case ',':
            ++values;
            break;
        default:
            break;
        }
    }
    if (objects > max_objects || values > max_values)
        throw Error(file, fmt::format("has too much JSON: {} objects, {} values", objects, values));
}

bool fits_float(const json& value) {
    return value.is_number() && std::abs(value.get<double>()) <= std::numeric_limits<float>::max();
}

} // namespace

json parse_gltf_json(std::string_view text, const std::string& file) {
    // GLB pads with spaces; some writers pad with zeros.
    while (!text.empty() && text.back() == '\0') text.remove_suffix(1);
    check_json_size(text, file);
    try {
        return json::parse(text);
    } catch (const json::parse_error& error) {
        throw Error(file, "is not valid JSON", fmt::format("byte {}", error.byte));
    } catch (const json::exception&) {
        throw Error(file, "has a number in its JSON that is out of range");
    }
}

std::string JsonPlace::pointer() const {
    if (parent_ == nullptr) return {};
    return parent_->pointer() + "/" + (key_.empty() ? std::to_string(element_) : pointer_token(key_));
}

void JsonPlace::fail(std::string_view fault) const {
    const std::string where = pointer();
    throw Error(*file_, fault, where.empty() ? "/" : where);
}

void JsonPlace::fail_at(std::string_view key, std::string_view fault) const {
    throw Error(*file_, fault, pointer() + "/" + pointer_token(key));
}

bool JsonPlace::has(std::string_view key) const { return json_->is_object() && json_->contains(key); }

json* JsonPlace::find(std::string_view key, Need need) const {
    if (!json_->is_object()) fail("must be an object");
    const auto it = json_->find(key);
    if (it != json_->end()) return &*it;
    if (need == Need::required) fail(fmt::format("lacks '{}'", key));
    return nullptr;
}

json* JsonPlace::find_array(std::string_view key, Need need) const {
    json* value = find(key, need);
    if (value != nullptr && !value->is_array()) fail_at(key, "must be an array");
    return value;
}

json* JsonPlace::find_object(std::string_view key, Need need) const {
    json* value = find(key, need);
    if (value != nullptr && !value->is_object()) fail_at(key, "must be an object");
    return value;
}

std::size_t JsonPlace::array_size(std::string_view key) const {
    const json* value = find_array(key, Need::optional);
    return value != nullptr ? value->size() : 0;
}

void JsonPlace::string(std::string_view key, Need need) const {
    const json* value = find(key, need);
    if (value != nullptr && !value->is_string()) fail_at(key, "must be a string");
}

void JsonPlace::choice(std::string_view key, std::initializer_list<std::string_view> choices, Need need) const {
    const json* value = find(key, need);
    if (value == nullptr) return;
    const auto matches = [&](std::string_view one) { return *value == one; };
    if (!value->is_string() || std::none_of(choices.begin(), choices.end(), matches))
        fail_at(key, fmt::format("must be one of {}", fmt::join(choices, ", ")));
}

void JsonPlace::strings(std::string_view key) const {
    const json* value = find_array(key, Need::optional);
    if (value == nullptr) return;
    if (!std::all_of(value->begin(), value->end(), [](const json& one) { return one.is_string(); }))
        fail_at(key, "must be an array of strings");
}

void JsonPlace::boolean(std::string_view key) const {
    const json* value = find(key, Need::optional);
    if (value != nullptr && !value->is_boolean()) fail_at(key, "must be true or false");
}

void JsonPlace::number(std::string_view key, Need need) const {
    const json* value = find(key, need);
    if (value != nullptr && !fits_float(*value)) fail_at(key, "must be a number that a float can hold");
}

void JsonPlace::numbers(std::string_view key, std::size_t count) const {
    const json* value = find_array(key, Need::optional);
    if (value == nullptr) return;
    if (count != 0 && value->size() != count) fail_at(key, fmt::format("must have {} numbers", count));
    if (!std::all_of(value->begin(), value->end(), fits_float)) fail_at(key, "must be numbers that a float can hold");
}

std::size_t JsonPlace::checked_integer(json& value, std::string_view key, std::size_t low, std::size_t high) const {
    if (value.is_number_float()) {
        const double number = value.get<double>();
        if (number >= 0.0 && number <= 4294967295.0 && number == std::floor(number))
            value = static_cast<std::uint64_t>(number);
    }
    const bool whole = value.is_number_unsigned();
    const std::size_t number = whole ? value.get<std::size_t>() : 0;
    if (!whole || number < low || number > high)
        fail_at(key, fmt::format("must be a whole number from {} to {}", low, high));
    return number;
}

std::size_t JsonPlace::integer(std::string_view key, std::size_t low, std::size_t high, Need need,
                               std::size_t absent) const {
    json* value = find(key, need);
    return value != nullptr ? checked_integer(*value, key, low, high) : absent;
}

std::size_t JsonPlace::index(std::string_view key, std::size_t count, Need need) const {
    if (count == 0 && has(key)) fail_at(key, "is an index into an array that is empty or absent");
    return integer(key, 0, count - 1, need, count);
}

void JsonPlace::indices(std::string_view key, std::size_t count, Need need) const {
    json* value = find_array(key, need);
    if (value == nullptr || value->empty()) return;
    if (count == 0) fail_at(key, "holds indices into an array that is empty or absent");
    for (json& element : *value) checked_integer(element, key, 0, count - 1);
}

void JsonPlace::index_members(std::size_t count) const {
    for (const auto& [name, value] : json_->items()) index(name, count);
}

void JsonPlace::object(std::string_view key, const Visit& visit, Need need) const {
    if (json* value = find_object(key, need)) visit(JsonPlace(*value, *this, key, 0));
}

void JsonPlace::each(std::string_view key, const Visit& visit, Need need) const {
    json* array = find_array(key, need);
    if (array == nullptr) return;
    const JsonPlace list(*array, *this, key, 0);
    for (std::size_t i = 0; i < array->size(); ++i) {
        const JsonPlace place((*array)[i], list, {}, i);
        if (!(*array)[i].is_object()) place.fail("must be an object");
        visit(place);
    }
}

void JsonPlace::extension(std::string_view name, const Visit& visit) const {
    object("extensions", [&](const JsonPlace& extensions) { extensions.object(name, visit); });
}

} // namespace hachure::assets
