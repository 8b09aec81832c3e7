#pragma once

#include <hachure/runtime/ecs/reflect.h>

#include <string>

namespace hachure {

/// The reference page of the registered components, docs/components.md: Markdown with a section per component and a
/// row per field, by name of component and in the fields' own order.
[[nodiscard]] std::string component_reference(const TypeRegistry& types);

} // namespace hachure
