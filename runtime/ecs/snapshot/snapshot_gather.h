#pragma once

#include <hachure/runtime/ecs/reflect.h>
#include <hachure/runtime/ecs/snapshot/snapshot_bytes.h>

#include <span>
#include <vector>

namespace hachure::detail {

/// Writes the column of a field: what differs from the default among `components`, all of the field's type. `scratch`
/// keeps its memory between calls. Throws Error(component.field, fault) when a component holds what its field forbids,
/// since no snapshot with it could be restored.
void write_field_column(ByteWriter& out, const FieldInfo& field, std::span<const void* const> components,
                        std::vector<std::byte>& scratch);

} // namespace hachure::detail
