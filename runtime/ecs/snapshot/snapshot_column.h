#pragma once

#include <hachure/runtime/ecs/snapshot/snapshot_selection.h>
#include <hachure/runtime/ecs/snapshot/snapshot_values.h>

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace hachure::detail {

/// One field of a component type as it lies in a snapshot: a default, and the values of the rows that differ from it.
/// It says itself how it is read, so that it can be kept without knowing the field. Views of the snapshot's bytes.
struct Column {
    std::string_view name;
    ValueCode code = ValueCode::boolean;
    OptionNames options; ///< of an enumeration
    Bytes default_value; ///< as `take_value` gives it
    Selection given;     ///< the rows that have a value of their own
    Bytes values;        ///< theirs, one after the other
    Bytes raw;           ///< the whole column as it was read
};

/// A component type in a snapshot. Rows are entities that carry it, in order of slots.
struct TypeBlock {
    std::string_view name;
    Selection rows; ///< among the live entities, in order of slots
    std::vector<Column> columns;
};

inline constexpr std::uint32_t no_new_row = 0xffff'ffffu;

/// Reads a block. `entities` is how many were alive. Throws Error for whatever is not a block; nothing that follows
/// needs to look at lengths and counts again.
TypeBlock read_type_block(ByteReader& in, std::uint32_t entities);

/// What comes before the columns, their number included.
void write_type_head(ByteWriter& out, std::string_view name, const Bits& rows, std::size_t columns);

/// `values` are those of the rows in `given`, encoded. `default_value` is as `encode_value` writes it.
void write_column(ByteWriter& out, std::string_view name, ValueCode code, const OptionNames& options,
                  Bytes default_value, const Bits& given, Bytes values);

/// Writes a column for other rows: row r of it becomes new_row[r], which ascends, or goes when that is no_new_row.
void write_column_for_rows(ByteWriter& out, const Column& column, std::span<const std::uint32_t> new_row,
                           std::uint32_t new_rows);

} // namespace hachure::detail
