#pragma once

#include <hachure/runtime/ecs/entity.h>
#include <hachure/runtime/ecs/storage/location.h>

namespace hachure::detail {

/// Where the rows of a table are noted by entity.
class RowIndex {
public:
    virtual ~RowIndex() = default;

    /// The row of `entity` is at `at` now.
    virtual void set_row(Entity entity, Location at) = 0;
};

} // namespace hachure::detail
