#include <hachure/runtime/ecs/snapshot/snapshot_column.h>
#include <hachure/runtime/ecs/type_hash.h>

#include <set>

namespace hachure::detail {
namespace {

Column read_column(ByteReader& in, std::uint32_t rows) {
    const std::size_t left = in.left();
    Column column;
    column.name = in.name();
    const auto code = value_code(in.number<std::uint8_t>());
    if (!code) in.fail("has a field of no known kind");
    column.code = *code;
    if (column.code == ValueCode::enumeration) {
        const auto count = in.number<std::uint16_t>();
        for (std::uint16_t i = 0; i < count; ++i) column.options.push_back(in.name());
    }
    column.default_value = take_value(in, column.code);
    column.given = read_selection(in, rows);
    const std::size_t begin = in.left();
    if (column.code == ValueCode::text)
        for (std::uint32_t i = 0; i < column.given.count; ++i) take_value(in, column.code);
    else
        in.take(std::uint64_t{column.given.count} * width(column.code));
    column.values = in.taken_since(begin);
    column.raw = in.taken_since(left);
    return column;
}

} // namespace

TypeBlock read_type_block(ByteReader& in, std::uint32_t entities) {
    TypeBlock block;
    block.name = in.name();
    if (in.number<std::uint64_t>() != type_hash(block.name)) in.fail("has a component whose name and id don't agree");
    block.rows = read_selection(in, entities);
    std::set<std::string_view> names;
    const auto count = in.number<std::uint16_t>();
    for (std::uint16_t i = 0; i < count; ++i) {
        block.columns.push_back(read_column(in, block.rows.count));
        if (!names.insert(block.columns.back().name).second) in.fail("has a field twice");
    }
    in.expect_end();
    return block;
}

void write_type_head(ByteWriter& out, std::string_view name, const Bits& rows, std::size_t columns) {
    out.name(name);
    out.number(type_hash(name));
    write_selection(out, rows);
    out.number(static_cast<std::uint16_t>(columns));
}

void write_column(ByteWriter& out, std::string_view name, ValueCode code, const OptionNames& options,
                  Bytes default_value, const Bits& given, Bytes values) {
    out.name(name);
    out.number(code);
    if (code == ValueCode::enumeration) {
        out.number(static_cast<std::uint16_t>(options.size()));
        for (const std::string_view option : options) out.name(option);
    }
    out.bytes(default_value);
    write_selection(out, given);
    out.bytes(values);
}

void write_column_for_rows(ByteWriter& out, const Column& column, std::span<const std::uint32_t> new_row,
                           std::uint32_t new_rows) {
    std::vector<std::byte> default_value;
    ByteWriter defaults(default_value);
    if (column.code == ValueCode::text) defaults.number(static_cast<std::uint32_t>(column.default_value.size()));
    defaults.bytes(column.default_value);
    Bits given(new_rows);
    std::vector<std::byte> values;
    ByteReader old_values(column.values, {});
    for (SelectionCursor cursor(column.given); !cursor.done(); cursor.next()) {
        const std::size_t left = old_values.left();
        take_value(old_values, column.code);
        const std::uint32_t row = new_row[cursor.at()];
        if (row == no_new_row) continue;
        given.set(row);
        ByteWriter(values).bytes(old_values.taken_since(left));
    }
    write_column(out, column.name, column.code, column.options, default_value, given, values);
}

} // namespace hachure::detail
