#pragma once

#include <hachure/runtime/ecs/reflect.h>
#include <hachure/runtime/ecs/snapshot/snapshot_field.h>

#include <span>

namespace hachure::detail {

/// Adds the type's component to `rows` with the columns' values. Columns are those of `match_field`.
void add_components(World& world, const TypeInfo& type, std::span<const Entity> rows,
                    std::span<const FieldColumn> columns);

} // namespace hachure::detail
