#include <hachure/runtime/ecs/storage/column_ticks.h>

namespace hachure::detail {

Tick* ColumnTicks::make_changed_rows(std::uint32_t capacity) {
    if (!rows_) rows_ = std::make_unique<Rows>();
    rows_->changed = std::make_unique<Tick[]>(capacity);
    return rows_->changed.get();
}

void ColumnTicks::place_apart(std::uint32_t row, std::uint32_t rows, std::uint32_t capacity, Tick added, Tick changed) {
    if ((rows_ && rows_->changed) || changed != changed_all_) {
        Tick* each = changed_rows(capacity);
        if (changed < changed_all_) {
            for (std::uint32_t i = 0; i < rows; ++i) each[i] = std::max(each[i], changed_all_);
            changed_all_ = 0;
        }
        each[row] = changed;
    }
    if ((rows_ && rows_->added) || added != added_all_) {
        if (!rows_) rows_ = std::make_unique<Rows>();
        if (!rows_->added) {
            rows_->added = std::make_unique<Tick[]>(capacity);
            std::fill_n(rows_->added.get(), rows, added_all_);
        }
        rows_->added[row] = added;
    }
    latest_ = std::max(latest_, changed);
}

} // namespace hachure::detail
