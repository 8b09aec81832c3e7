#pragma once

#include <hachure/runtime/ecs/entity.h>
#include <hachure/runtime/ecs/storage/growing_array.h>
#include <hachure/runtime/ecs/tick.h>
#include <hachure/runtime/ecs/type_id.h>

#include <cstddef>
#include <span>
#include <vector>

namespace hachure::detail {

class Table;

/// Which entities lost what, in order of time. The destruction of an entity is one entry, however many components it
/// had.
class RemovalLog {
public:
    /// `entity` was in `table` and lost all of its components.
    void note_destroyed(Entity entity, const Table& table, Tick now) {
        note(entity, {now, &table, 0, entities_.size()});
    }

    void note_destroyed(std::span<const Entity> entities, const Table& table, Tick now) {
        if (entities.empty()) return;
        note(entities.front(), {now, &table, 0, entities_.size()});
        entities_.append(entities.subspan(1));
    }

    /// `entity` lost one component.
    void note_removed(Entity entity, TypeId component, Tick now) {
        note(entity, {now, nullptr, component, entities_.size()});
    }

    /// Entities that lost `component` after `since`.
    std::vector<Entity> since(TypeId component, Tick since) const;

    /// Forgets what was before `tick`.
    void forget_before(Tick tick);

private:
    /// Entries of the same tick and kind, from `begin` to the begin of the next run.
    struct Run {
        Tick tick;
        const Table* table; ///< null for single components
        TypeId component;
        std::size_t begin;

        bool continues(const Run& other) const {
            return tick == other.tick && table == other.table && component == other.component;
        }
    };

    void note(Entity entity, const Run& run) {
        if (runs_.empty() || !runs_.back().continues(run)) runs_.push_back(run);
        entities_.push_back(entity);
    }

    std::vector<Run> runs_;
    GrowingArray<Entity> entities_;
};

} // namespace hachure::detail
