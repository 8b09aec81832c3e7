#include <hachure/runtime/ecs/reflect.h>

#include <algorithm>

namespace hachure {
namespace {

/// Names are parts of paths such as `gooch.b` and `entity/gooch.b`.
bool is_name(std::string_view text) {
    return !text.empty() && std::ranges::all_of(text, [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_';
    });
}

void complete(FieldInfo& field, const TypeInfo& type, const void* defaults) {
    HACHURE_ASSERT(is_name(field.name), "a field has a name in lower case with underscores");
    HACHURE_ASSERT(std::ranges::count(type.fields, field.name, &FieldInfo::name) == 1, "a field's name is its own");
    HACHURE_ASSERT(field.kind != FieldKind::enumeration || !field.options.empty(), "an enumeration has options");
    field.path = type.name + '.' + field.name;
    field.default_value = field.get(defaults);
    HACHURE_ASSERT(field.fault(field.default_value).empty(), "a default is within its own range");
}

} // namespace

const FieldInfo* TypeInfo::field(std::string_view field_name) const {
    const auto found = std::ranges::find(fields, field_name, &FieldInfo::name);
    return found != fields.end() ? &*found : nullptr;
}

FieldBuilder& FieldBuilder::doc(std::string_view text) {
    field_->doc = text;
    return *this;
}

FieldBuilder& FieldBuilder::unit(std::string_view text) {
    field_->unit = text;
    return *this;
}

FieldBuilder& FieldBuilder::range(double min, double max) {
    HACHURE_ASSERT(min <= max, "a range is not empty");
    HACHURE_ASSERT(field_->kind != FieldKind::boolean && field_->kind != FieldKind::text &&
                       field_->kind != FieldKind::enumeration && field_->kind != FieldKind::quaternion &&
                       field_->kind != FieldKind::entity,
                   "a range is for numbers, vectors and colours");
    field_->range = FieldRange{min, max};
    return *this;
}

FieldBuilder& FieldBuilder::color() {
    HACHURE_ASSERT(field_->kind == FieldKind::vec3 || field_->kind == FieldKind::vec4, "a colour is a vec3 or a vec4");
    field_->kind = FieldKind::color;
    return *this;
}

FieldBuilder& FieldBuilder::options(std::initializer_list<std::string_view> names) {
    HACHURE_ASSERT(field_->kind == FieldKind::enumeration, "options are for enumerations");
    field_->options.assign(names.begin(), names.end());
    return *this;
}

const TypeInfo* TypeRegistry::find(std::string_view name) const {
    const auto found = std::ranges::find(types_, name, &TypeInfo::name);
    return found != types_.end() ? &*found : nullptr;
}

const TypeInfo* TypeRegistry::find(detail::TypeId component) const {
    const auto found = std::ranges::find(types_, component, &TypeInfo::component);
    return found != types_.end() ? &*found : nullptr;
}

const TypeInfo& TypeRegistry::insert(TypeInfo type, const void* defaults) {
    HACHURE_ASSERT(is_name(type.name), "a type has a name in lower case with underscores");
    HACHURE_ASSERT(!find(type.name), "a type's name is its own");
    type.id = type_hash(type.name);
    HACHURE_ASSERT(std::ranges::find(types_, type.id, &TypeInfo::id) == types_.end(),
                   "two names of types have the same hash; rename one");
    for (FieldInfo& field : type.fields) complete(field, type, defaults);
    return types_.emplace_back(std::move(type));
}

} // namespace hachure
