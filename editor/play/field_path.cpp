#include <hachure/editor/play/field_path.h>
#include <hachure/runtime/error.h>

#include <algorithm>

namespace hachure::play {
namespace {

std::vector<std::string_view> split(std::string_view text) {
    std::vector<std::string_view> parts;
    for (std::size_t dot = text.find('.'); dot != text.npos; dot = text.find('.')) {
        parts.push_back(text.substr(0, dot));
        text.remove_prefix(dot + 1);
    }
    parts.push_back(text);
    return parts;
}

std::size_t parse_element(const FieldInfo& field, std::string_view text) {
    const std::vector<std::string> names = element_names(field);
    const auto found = std::ranges::find(names, "." + std::string(text));
    if (found == names.end()) throw Error("'" + field.path + "' has no element '" + std::string(text) + "'");
    return static_cast<std::size_t>(found - names.begin());
}

} // namespace

std::vector<std::string> element_names(const FieldInfo& field) {
    const std::size_t count = numbers(field.default_value).size();
    if (count == 0) return {};
    if (count == 1) return {""};
    const std::vector<std::string> all = field.kind == FieldKind::color
                                             ? std::vector<std::string>{".r", ".g", ".b", ".a"}
                                             : std::vector<std::string>{".x", ".y", ".z", ".w"};
    return {all.begin(), all.begin() + static_cast<std::ptrdiff_t>(count)};
}

FieldPath parse_field_path(const TypeRegistry& types, std::string_view text) {
    FieldPath path;
    if (const std::size_t slash = text.rfind('/'); slash != text.npos) {
        path.entity = text.substr(0, slash);
        text.remove_prefix(slash + 1);
    }
    const std::vector<std::string_view> parts = split(text);
    if (parts.size() < 2 || parts.size() > 3)
        throw Error("'" + std::string(text) + "' is no component.field or component.field.element");
    path.type = types.find(parts[0]);
    if (!path.type) throw Error("there is no component '" + std::string(parts[0]) + "'");
    path.field = path.type->field(parts[1]);
    if (!path.field) throw Error("component '" + path.type->name + "' has no field '" + std::string(parts[1]) + "'");
    if (parts.size() == 3) path.element = parse_element(*path.field, parts[2]);
    return path;
}

std::vector<const void*> find_components(const FieldPath& path, const World& world, const NameIndex& names) {
    std::vector<const void*> result;
    for (const Entity entity : path.entity.empty() ? path.type->entities(world) : names.find_all(world, path.entity))
        if (const void* component = path.type->find(world, entity)) result.push_back(component);
    return result;
}

std::vector<double> numbers(const FieldValue& value) {
    return std::visit(
        [](const auto& v) -> std::vector<double> {
            using V = std::decay_t<decltype(v)>;
            if constexpr (std::is_arithmetic_v<V>) {
                return {static_cast<double>(v)};
            } else if constexpr (std::is_same_v<V, std::string> || std::is_same_v<V, Entity>) {
                return {};
            } else {
                std::vector<double> result;
                for (int i = 0; i < v.length(); ++i) result.push_back(static_cast<double>(v[i]));
                return result;
            }
        },
        value);
}

} // namespace hachure::play
