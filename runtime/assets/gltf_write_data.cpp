#include <hachure/runtime/assets/gltf_write_data.h>

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <functional>
#include <string_view>

namespace hachure::assets {
namespace {

using nlohmann::json;

static_assert(std::endian::native == std::endian::little, "glTF's buffers are little-endian");

constexpr int type_byte = 5121, type_short = 5123, type_int = 5125, type_float = 5126;

template <class T> std::span<const std::byte> bytes_of(std::span<const T> values) { return std::as_bytes(values); }

template <class T> std::span<const std::byte> bytes_of(const std::vector<T>& values) {
    return std::as_bytes(std::span(values));
}

/// {"min": [...], "max": [...]} of vectors of `width` floats.
json bounds_of(std::span<const float> values, std::size_t width) {
    if (values.empty()) return {};
    std::vector<float> low(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(width)), high = low;
    for (std::size_t i = 0; i < values.size(); ++i) {
        low[i % width] = std::min(low[i % width], values[i]);
        high[i % width] = std::max(high[i % width], values[i]);
    }
    json result{{"min", json::array()}, {"max", json::array()}};
    for (const float number : low) result["min"].push_back(gltf_number(number));
    for (const float number : high) result["max"].push_back(gltf_number(number));
    return result;
}

} // namespace

json gltf_number(float number) {
    const std::string text = fmt::format("{}", number);
    double result = 0;
    std::from_chars(text.data(), text.data() + text.size(), result);
    return result;
}

std::size_t GltfData::bytes(std::span<const std::byte> bytes, GltfTarget target) {
    const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    const std::size_t hash = std::hash<std::string_view>{}(text) ^ static_cast<std::size_t>(target);
    const auto [first, last] = view_by_hash_.equal_range(hash);
    for (auto entry = first; entry != last; ++entry) {
        const json& view = views_[entry->second];
        const auto offset = view.at("byteOffset").get<std::size_t>();
        if (view.at("byteLength") == bytes.size() && view.value("target", 0) == static_cast<int>(target) &&
            std::equal(bytes.begin(), bytes.end(), buffer_.begin() + static_cast<std::ptrdiff_t>(offset)))
            return entry->second;
    }
    buffer_.resize((buffer_.size() + 3) / 4 * 4);
    json view{{"buffer", 0}, {"byteOffset", buffer_.size()}, {"byteLength", bytes.size()}};
    if (target != GltfTarget::none) view["target"] = static_cast<int>(target);
    buffer_.insert(buffer_.end(), bytes.begin(), bytes.end());
    views_.push_back(std::move(view));
    view_by_hash_.emplace(hash, views_.size() - 1);
    return views_.size() - 1;
}

std::size_t GltfData::accessor(std::span<const std::byte> data, const Shape& shape, GltfTarget target, json bounds) {
    json accessor = std::move(bounds);
    accessor["bufferView"] = bytes(data, target);
    accessor["componentType"] = shape.component;
    accessor["count"] = shape.count;
    accessor["type"] = shape.type;
    const auto [entry, fresh] = accessor_by_text_.try_emplace(accessor.dump(), accessors_.size());
    if (fresh) accessors_.push_back(std::move(accessor));
    return entry->second;
}

template <class V>
std::size_t GltfData::of_floats(std::span<const V> values, std::string_view type, GltfTarget target, bool bounds) {
    const std::size_t width = sizeof(V) / sizeof(float);
    const std::span<const float> floats(reinterpret_cast<const float*>(values.data()), values.size() * width);
    return accessor(bytes_of(values), {type, type_float, values.size()}, target,
                    bounds ? bounds_of(floats, width) : json());
}

std::size_t GltfData::scalars(std::span<const float> values, bool bounds) {
    return of_floats(values, "SCALAR", GltfTarget::none, bounds);
}

std::size_t GltfData::vectors(std::span<const glm::vec2> values, GltfTarget target) {
    return of_floats(values, "VEC2", target, false);
}

std::size_t GltfData::vectors(std::span<const glm::vec3> values, GltfTarget target, bool bounds) {
    return of_floats(values, "VEC3", target, bounds);
}

std::size_t GltfData::vectors(std::span<const glm::vec4> values, GltfTarget target) {
    return of_floats(values, "VEC4", target, false);
}

std::size_t GltfData::matrices(std::span<const glm::mat4> values) {
    return of_floats(values, "MAT4", GltfTarget::none, false);
}

std::size_t GltfData::groups(std::span<const float> values, std::size_t width) {
    const std::string_view type = width == 2 ? "VEC2" : width == 3 ? "VEC3" : width == 4 ? "VEC4" : "SCALAR";
    const std::size_t per_element = type == "SCALAR" ? 1 : width;
    return accessor(bytes_of(values), {type, type_float, values.size() / per_element}, GltfTarget::none);
}

std::size_t GltfData::indices(std::span<const std::uint32_t> values) {
    // 65535 is what some programs restart strips with.
    if (std::ranges::all_of(values, [](std::uint32_t index) { return index < 65535; })) {
        const std::vector<std::uint16_t> narrow(values.begin(), values.end());
        return accessor(bytes_of(narrow), {"SCALAR", type_short, values.size()}, GltfTarget::indices);
    }
    return accessor(bytes_of(values), {"SCALAR", type_int, values.size()}, GltfTarget::indices);
}

std::size_t GltfData::joints(std::span<const glm::u16vec4> values) {
    const auto fits = [](const glm::u16vec4& four) { return std::max({four.x, four.y, four.z, four.w}) < 256; };
    if (!std::ranges::all_of(values, fits))
        return accessor(bytes_of(values), {"VEC4", type_short, values.size()}, GltfTarget::vertices);
    std::vector<glm::u8vec4> narrow(values.size());
    std::ranges::transform(values, narrow.begin(), [](const glm::u16vec4& four) { return glm::u8vec4(four); });
    return accessor(bytes_of(narrow), {"VEC4", type_byte, values.size()}, GltfTarget::vertices);
}

} // namespace hachure::assets
