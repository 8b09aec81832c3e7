#include <hachure/editor/component_reference.h>

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace hachure {
namespace {

constexpr const char* introduction = R"(# Components

What entities can carry, and what of it files and users can set: in style presets, and with
`hachure render --set component.field=value`. Vectors and colours are written `1 0 0`, in JSON `[1, 0, 0]`; colours are
linear light, or `#rrggbb` in sRGB; quaternions are x, y, z, w.

Written by `hachure list components --markdown > docs/components.md`.
)";

/// A table's cell: no bar and no line break ends it early.
std::string cell(std::string_view text) {
    std::string result;
    for (const char c : text) {
        if (c == '|') result += '\\';
        result += c == '\n' ? ' ' : c;
    }
    return result;
}

std::string kind_text(const FieldInfo& field) {
    if (field.kind == FieldKind::integer || field.kind == FieldKind::real)
        return fmt::format("{}, {} bits", to_string(field.kind), field.bits);
    return std::string(to_string(field.kind));
}

std::string allowed_text(const FieldInfo& field) {
    std::string names;
    for (const std::string& option : field.options) names += (names.empty() ? "`" : ", `") + option + '`';
    return field.range ? fmt::format("{:g} to {:g}", field.range->min, field.range->max) : names;
}

std::string default_text(const FieldInfo& field) {
    const std::string text = format_field(field, field.default_value);
    return text.empty() ? "empty" : '`' + text + '`';
}

std::string section(const TypeInfo& type) {
    std::string text = fmt::format("\n## {}\n\n{}\n", type.name, type.doc);
    if (type.fields.empty()) return text;
    text += "\n| field | kind | unit | allowed | default | |\n|---|---|---|---|---|---|\n";
    for (const FieldInfo& field : type.fields)
        text += fmt::format("| `{}` | {} | {} | {} | {} | {} |\n", field.name, kind_text(field), cell(field.unit),
                            cell(allowed_text(field)), cell(default_text(field)), cell(field.doc));
    return text;
}

} // namespace

std::string component_reference(const TypeRegistry& types) {
    std::vector<const TypeInfo*> sorted;
    for (const TypeInfo& type : types.types()) sorted.push_back(&type);
    std::ranges::sort(sorted, {}, &TypeInfo::name);
    std::string text = introduction;
    for (const TypeInfo* type : sorted) text += section(*type);
    return text;
}

} // namespace hachure
