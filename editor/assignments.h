#pragma once

#include <hachure/runtime/ecs/reflect.h>

#include <span>
#include <string>
#include <vector>

namespace hachure {

/// One `--set`: a value for a field, of every entity that carries the component or of those named.
struct Assignment {
    std::string entity; ///< a Name or a path of names, as NameIndex finds it; empty for all
    const TypeInfo* type = nullptr;
    const FieldInfo* field = nullptr;
    FieldValue value;
};

/// Reads `component.field=value` and `entity/component.field=value`, where entity may be a path of names. Throws
/// UsageError for anything else, for unknown components and fields, and for values that the field can't hold.
[[nodiscard]] std::vector<Assignment> parse_assignments(const TypeRegistry& types, std::span<const std::string> texts);

/// Writes the values, in order. Throws Error when no entity carries the component, or none of that name does.
void apply_assignments(World& world, std::span<const Assignment> assignments);

} // namespace hachure
