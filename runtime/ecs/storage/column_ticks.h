#pragma once

#include <hachure/runtime/ecs/tick.h>

#include <algorithm>
#include <cstdint>
#include <memory>

namespace hachure::detail {

/// When the components of one column of a chunk were added and last changed. Most columns were filled in one tick and
/// are changed by sweeps over all of them, which takes one number here; a tick for each row is kept only where rows
/// differ.
class ColumnTicks {
public:
    Tick changed(std::uint32_t row) const {
        return rows_ && rows_->changed ? std::max(rows_->changed[row], changed_all_) : changed_all_;
    }
    Tick added(std::uint32_t row) const { return rows_ && rows_->added ? rows_->added[row] : added_all_; }

    /// No row was changed later than this.
    Tick latest() const { return latest_; }

    /// The first row from `row` on, below `rows`, that was changed (or added) after `since`; `rows` when there is none.
    std::uint32_t next_changed(std::uint32_t row, std::uint32_t rows, Tick since) const {
        if (changed_all_ > since) return row;
        if (!rows_ || !rows_->changed) return rows;
        while (row < rows && rows_->changed[row] <= since) ++row;
        return row;
    }
    std::uint32_t next_added(std::uint32_t row, std::uint32_t rows, Tick since) const {
        if (!rows_ || !rows_->added) return added_all_ > since ? row : rows;
        while (row < rows && rows_->added[row] <= since) ++row;
        return row;
    }

    /// Sets both ticks of `row`, the chunk having `rows` rows below `capacity` before it, or containing it.
    void place(std::uint32_t row, std::uint32_t rows, std::uint32_t capacity, Tick added, Tick changed) {
        if (rows == 0) return begin(added, changed);
        if (!rows_ && changed == changed_all_ && added == added_all_) return;
        place_apart(row, rows, capacity, added, changed);
    }

    /// The same with the ticks that another column has in row `from`.
    void place(std::uint32_t row, std::uint32_t rows, std::uint32_t capacity, const ColumnTicks& source,
               std::uint32_t from) {
        if (rows > 0 && !rows_ && !source.rows_ && source.changed_all_ == changed_all_ &&
            source.added_all_ == added_all_)
            return;
        place(row, rows, capacity, source.added(from), source.changed(from));
    }

    /// Moves the ticks of row `from` to row `to` of this column.
    void move(std::uint32_t to, std::uint32_t from) {
        if (!rows_) return;
        if (rows_->changed) rows_->changed[to] = rows_->changed[from];
        if (rows_->added) rows_->added[to] = rows_->added[from];
    }

    /// Sets the ticks of `count` rows that follow `first` rows.
    void place_many(std::uint32_t first, std::uint32_t count, std::uint32_t capacity, Tick now) {
        if (first == 0) return begin(now, now);
        if (!rows_ && changed_all_ == now && added_all_ == now) return;
        for (std::uint32_t row = first; row < first + count; ++row) place(row, row, capacity, now, now);
    }

    /// Marks a row changed at `now`, the latest tick; false when it was already.
    bool mark(std::uint32_t row, std::uint32_t capacity, Tick now) {
        if (changed(row) == now) return false;
        changed_rows(capacity)[row] = now;
        latest_ = now;
        return true;
    }

    /// Marks all rows.
    void mark_all(Tick now) { changed_all_ = latest_ = now; }

private:
    struct Rows {
        std::unique_ptr<Tick[]> changed; ///< null where all are changed_all_; later than that where it says so
        std::unique_ptr<Tick[]> added;   ///< null where all are added_all_
    };

    void begin(Tick added, Tick changed) {
        changed_all_ = latest_ = changed;
        added_all_ = added;
        if (rows_) rows_.reset();
    }
    void place_apart(std::uint32_t row, std::uint32_t rows, std::uint32_t capacity, Tick added, Tick changed);
    Tick* changed_rows(std::uint32_t capacity) {
        return rows_ && rows_->changed ? rows_->changed.get() : make_changed_rows(capacity);
    }
    Tick* make_changed_rows(std::uint32_t capacity);

    Tick changed_all_ = 0; ///< every row was changed at this tick or later
    Tick added_all_ = 0;
    std::unique_ptr<Rows> rows_;
    Tick latest_ = 0;
};

} // namespace hachure::detail
