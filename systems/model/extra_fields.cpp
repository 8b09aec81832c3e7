#include <hachure/runtime/assets/path_rules.h>
#include <hachure/runtime/error.h>
#include <hachure/runtime/scene/file_fields.h>
#include <hachure/systems/model/extra_fields.h>

#include <nlohmann/json.hpp>

#include <cmath>

namespace hachure {
namespace {

using nlohmann::json;

/// What a tool that knows only numbers wrote for a truth value or a whole number.
json as_the_field_has_it(const FieldInfo& field, const json& value) {
    if (field.kind == FieldKind::boolean && value.is_number()) return value != json(0);
    if (field.kind != FieldKind::integer || !value.is_number_float()) return value;
    const double number = value.get<double>();
    const bool whole = std::abs(number) <= 9e15 && number == std::floor(number);
    return whole ? json(static_cast<std::int64_t>(number)) : value;
}

} // namespace

FieldValues ExtraFields::read(const TypeInfo& type, const json& fields, const std::string& speaker,
                              const std::string& pointer) {
    FieldValues result;
    for (const auto& [name, value] : fields.items()) {
        try {
            for (auto& field : read_one(type, name, value, {speaker, pointer})) result.push_back(std::move(field));
        } catch (const Error& error) {
            warnings_.emplace_back(error.what());
        }
    }
    return result;
}

FieldValues ExtraFields::read_one(const TypeInfo& type, const std::string& name, const json& value,
                                  const JsonPlace& place) {
    const FieldInfo* field = type.field(name);
    const std::string* text = field ? value.get_ptr<const std::string*>() : nullptr;
    if (text && field->kind == FieldKind::entity && *text != "null") {
        const Entity entity = entity_called(*text);
        if (!entity)
            throw Error(place.subject, field->path + ": there is no entity '" + text->substr(0, 100) + "'",
                        place.pointer + "/" + name);
        return {{field, entity}};
    }
    if (text && is_file_field(*field) && !text->empty())
        return {{field, assets::resolve_beside(file_, *text, place.pointer + "/" + name).string()}};
    return fields_from_json(type, {{name, field ? as_the_field_has_it(*field, value) : value}}, place);
}

Entity ExtraFields::entity_called(const std::string& path) {
    names_.update(world_);
    const std::vector<Entity> found = names_.find_all(world_, path);
    for (const Entity entity : found)
        for (Entity above = entity; above; above = world_.parent(above))
            if (above == root_) return entity;
    return found.empty() ? Entity::null : found.front();
}

} // namespace hachure
