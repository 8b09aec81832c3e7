#include <hachure/runtime/assert.h>
#include <hachure/runtime/ecs/snapshot/snapshot_fill.h>

#include <algorithm>
#include <string>
#include <vector>

namespace hachure::detail {
namespace {

/// Default-constructed components, one member of which is written.
struct Block {
    std::byte* member; ///< of the first component
    std::size_t stride;
    std::uint32_t first; ///< row of the first component
    std::uint32_t count;

    std::byte* of(std::uint32_t row) const { return member + std::size_t{row - first} * stride; }
};

void write_text(std::byte* member, Bytes value) {
    reinterpret_cast<std::string*>(member)->assign(reinterpret_cast<const char*>(value.data()), value.size());
}

void write_enumerator(std::byte* member, std::size_t size, Bytes value) {
    std::uint64_t index = 0;
    std::memcpy(&index, value.data(), sizeof(std::uint16_t));
    std::memcpy(member, &index, size);
}

/// Writes a column's values block by block, in order of rows.
class ColumnFill {
public:
    explicit ColumnFill(const FieldColumn& column)
        : column_(&column), cursor_(column.given), values_(column.values, {}) {}

    void fill(std::byte* components, std::size_t stride, std::uint32_t first, std::uint32_t count) {
        const Block block{components + column_->field->offset, stride, first, count};
        if (column_->other_default)
            for (std::uint32_t row = first; row < first + count; ++row) write(block.of(row), column_->default_value);
        switch (column_->code == ValueCode::enumeration ? 0 : width(column_->code)) {
        case 1:
            return fill_plain<1>(block);
        case 4:
            return fill_plain<4>(block);
        case 8:
            return fill_plain<8>(block);
        case 12:
            return fill_plain<12>(block);
        case 16:
            return fill_plain<16>(block);
        default:
            return fill_any(block);
        }
    }

private:
    void write(std::byte* member, Bytes value) const {
        if (column_->code == ValueCode::text) return write_text(member, value);
        if (column_->code == ValueCode::enumeration) return write_enumerator(member, column_->field->size, value);
        std::memcpy(member, value.data(), value.size());
    }

    template <std::size_t width> void fill_plain(const Block& block) {
        if (column_->given.form == Selection::Form::all) {
            const std::byte* value = values_.take(std::size_t{block.count} * width).data();
            for (std::uint32_t i = 0; i < block.count; ++i)
                std::memcpy(block.member + i * block.stride, value + i * width, width);
            return;
        }
        for (; cursor_.at() < block.first + block.count; cursor_.next())
            std::memcpy(block.of(cursor_.at()), values_.take(width).data(), width);
    }

    void fill_any(const Block& block) {
        for (; cursor_.at() < block.first + block.count; cursor_.next())
            write(block.of(cursor_.at()), take_value(values_, column_->code));
    }

    const FieldColumn* column_;
    SelectionCursor cursor_;
    ByteReader values_;
};

struct TypeFill {
    std::size_t stride;
    std::vector<ColumnFill> columns;
};

} // namespace

void add_components(World& world, const TypeInfo& type, std::span<const Entity> rows,
                    std::span<const FieldColumn> columns) {
    TypeFill fill{type.size, {columns.begin(), columns.end()}};
    type.add_many(
        world, rows,
        [](void* context, std::size_t first, std::size_t count, void* components) {
            auto& job = *static_cast<TypeFill*>(context);
            for (ColumnFill& column : job.columns)
                column.fill(static_cast<std::byte*>(components), job.stride, static_cast<std::uint32_t>(first),
                            static_cast<std::uint32_t>(count));
        },
        &fill);
}

} // namespace hachure::detail
