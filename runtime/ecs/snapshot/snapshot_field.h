#pragma once

#include <hachure/runtime/ecs/snapshot/snapshot_column.h>

#include <cstddef>
#include <deque>
#include <string_view>
#include <vector>

namespace hachure::detail {

/// A column of a snapshot as a field of this program takes it: of its code, with its options, checked.
struct FieldColumn {
    const FieldInfo* field = nullptr;
    ValueCode code = ValueCode::boolean;
    Selection given;
    Bytes values;
    Bytes default_value;        ///< of the rows that are not in `given`, as `take_value` gives it
    bool other_default = false; ///< whether that is another than the field has
};

/// Where converted columns lie; stays as long as they are used.
using ColumnArena = std::deque<std::vector<std::byte>>;

/// Converts and checks a column. Throws Error naming `component.field` when its values are of a kind that can't become
/// the field's, or when the field can't hold one of them.
FieldColumn match_field(const Column& column, const FieldInfo& field, std::string_view subject, ColumnArena& arena);

/// What is wrong with one of the values, as FieldInfo::fault says it; empty when all are fine. `count` values of the
/// field's own code lie in `values`.
std::string values_fault(const FieldInfo& field, std::uint32_t count, Bytes values);

} // namespace hachure::detail
