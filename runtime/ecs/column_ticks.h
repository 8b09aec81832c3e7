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
        return changed_rows_ ? std::max(changed_rows_[row], changed_all_) : changed_all_;
    }
    Tick added(std::uint32_t row) const { return added_rows_ ? added_rows_[row] : added_all_; }

    /// No row was changed later than this.
    Tick latest() const { return latest_; }

    /// The first row from `row` on, below `rows`, that was changed (or added) after `since`; `rows` when there is none.
    std::uint32_t next_changed(std::uint32_t row, std::uint32_t rows, Tick since) const {
        if (changed_all_ > since) return row;
        if (!changed_rows_) return rows;
        while (row < rows && changed_rows_[row] <= since) ++row;
        return row;
    }
    std::uint32_t next_added(std::uint32_t row, std::uint32_t rows, Tick since) const {
        if (!added_rows_) return added_all_ > since ? row : rows;
        while (row < rows && added_rows_[row] <= since) ++row;
        return row;
    }

    /// Whether all rows have the same ticks without asking further.
    bool uniform() const { return !changed_rows_ && !added_rows_; }

    /// Sets both ticks of `row`, the chunk having `rows` rows below `capacity` before it, or containing it.
    void place(std::uint32_t row, std::uint32_t rows, std::uint32_t capacity, Tick added, Tick changed) {
        if (rows == 0) return begin(added, changed);
        if (changed_rows_ || changed != changed_all_) place_changed(row, rows, capacity, changed);
        if (added_rows_ || added != added_all_) place_added(row, rows, capacity, added);
        latest_ = std::max(latest_, changed);
    }

    /// Sets the ticks of `count` rows that follow `first` rows.
    void place_many(std::uint32_t first, std::uint32_t count, std::uint32_t capacity, Tick now) {
        if (first == 0) return begin(now, now);
        if (uniform() && changed_all_ == now && added_all_ == now) return;
        for (std::uint32_t row = first; row < first + count; ++row) place(row, row, capacity, now, now);
    }

    /// Marks a row changed at `now`, the latest tick; false when it was already.
    bool mark(std::uint32_t row, std::uint32_t capacity, Tick now) {
        if (changed(row) == now) return false;
        if (!changed_rows_) changed_rows_ = std::make_unique<Tick[]>(capacity);
        changed_rows_[row] = now;
        latest_ = now;
        return true;
    }

    /// Marks all rows.
    void mark_all(Tick now) { changed_all_ = latest_ = now; }

    /// The first row of an empty chunk.
    void begin(Tick added, Tick changed) {
        changed_all_ = latest_ = changed;
        added_all_ = added;
        changed_rows_.reset();
        added_rows_.reset();
    }

private:
    void place_changed(std::uint32_t row, std::uint32_t rows, std::uint32_t capacity, Tick changed) {
        if (!changed_rows_) changed_rows_ = std::make_unique<Tick[]>(capacity);
        if (changed < changed_all_) {
            for (std::uint32_t i = 0; i < rows; ++i) changed_rows_[i] = std::max(changed_rows_[i], changed_all_);
            changed_all_ = 0;
        }
        changed_rows_[row] = changed;
    }

    void place_added(std::uint32_t row, std::uint32_t rows, std::uint32_t capacity, Tick added) {
        if (!added_rows_) {
            added_rows_ = std::make_unique<Tick[]>(capacity);
            std::fill_n(added_rows_.get(), rows, added_all_);
        }
        added_rows_[row] = added;
    }

    Tick latest_ = 0;
    Tick changed_all_ = 0; ///< every row was changed at this tick or later
    Tick added_all_ = 0;   ///< of every row, unless added_rows_ is there
    std::unique_ptr<Tick[]> changed_rows_;
    std::unique_ptr<Tick[]> added_rows_;
};

} // namespace hachure::detail
