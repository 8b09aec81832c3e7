#pragma once

#include <hachure/components/name_index.h>
#include <hachure/components/timeline.h>

#include <string>
#include <string_view>
#include <unordered_set>
#include <vector>

namespace hachure {

/// Which entities the targets of timelines are, and whether that may have changed.
class TimelineTargets {
public:
    /// Takes in what became of names and of the tree. True when that can touch a target that was resolved: an entity of
    /// that name has come, or one that a target is, or stands below, has gone, moved or changed its name.
    bool update(const World& world);

    /// Looks for what a timeline's document names. Null where there is none.
    void resolve(const World& world, Entity carrier, const TimelineDocument& document, std::vector<Entity>& targets);

    /// One by its path: below the carrier, or else anywhere; the carrier itself when the path is empty. As of the last
    /// update; null when there is none.
    [[nodiscard]] Entity find(const World& world, Entity carrier, std::string_view path) const;

    /// Forgets what was resolved, before all is resolved again.
    void forget();

private:
    void watch(const World& world, std::string_view path, Entity entity);
    [[nodiscard]] bool named_as_a_target(const World& world, Entity entity) const;
    [[nodiscard]] bool names_matter(const World& world) const;
    [[nodiscard]] bool tree_matters(const World& world) const;

    NameIndex index_;
    std::unordered_set<std::string> names_; ///< in the paths of targets
    std::unordered_set<Entity> entities_;   ///< that targets are, and the ones above that their paths name
    Tick seen_ = 0;                         ///< all changes up to this tick are known
};

} // namespace hachure
