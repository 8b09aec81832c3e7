#pragma once

#include <hachure/components/name_index.h>
#include <hachure/runtime/ecs/reflect.h>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace hachure::play {

/// A field of components in a world: "Fox/transform.translation.y", "camera.yfov".
struct FieldPath {
    std::string entity; ///< a name or a path of names; empty for every entity that carries the component
    const TypeInfo* type = nullptr;
    const FieldInfo* field = nullptr;
    std::optional<std::size_t> element; ///< of a vector, colour or quaternion: x or r is 0
};

/// Reads one. Throws Error (the fault alone, in words) for what there is not.
[[nodiscard]] FieldPath parse_field_path(const TypeRegistry& types, std::string_view text);

/// The components that it means now, in no order; they hold until the world changes.
[[nodiscard]] std::vector<const void*> find_components(const FieldPath& path, const World& world,
                                                       const NameIndex& names);

/// A value as numbers: 1 for scalars and booleans, one per element of vectors; none for texts, options and entities.
[[nodiscard]] std::vector<double> numbers(const FieldValue& value);

/// What the elements of the field's values are called: ".x", ".r"; one empty name for scalars.
[[nodiscard]] std::vector<std::string> element_names(const FieldInfo& field);

} // namespace hachure::play
