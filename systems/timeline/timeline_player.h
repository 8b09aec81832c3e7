#pragma once

#include <hachure/components/timeline.h>
#include <hachure/runtime/ecs/world.h>
#include <hachure/systems/timeline/timeline.h>
#include <hachure/systems/timeline/timeline_clock.h>
#include <hachure/systems/timeline/timeline_targets.h>
#include <hachure/systems/timeline/track_writer.h>
#include <hachure/systems/timeline/warn_once.h>

#include <cstdint>
#include <memory>
#include <unordered_set>
#include <vector>

namespace hachure {

/// Plays the document of one timeline: keeps where its searches were, and memory.
class TimelinePlayer {
public:
    TimelinePlayer(const TypeRegistry& types, std::shared_ptr<const TimelineDocument> document);

    [[nodiscard]] const TimelineDocument& document() const { return *document_; }

    /// Looks for the targets by name, if need be again. What is not there is a warning, except where an action makes
    /// or destroys it.
    void resolve(const World& world, Entity carrier, TimelineTargets& targets, WarnOnce& warnings);

    /// Gives what the tracks move, and what goes along paths, the values of the clock's place.
    void show(World& world, TimelineCounts& counts, WarnOnce& warnings);

    /// Turns what looks at something.
    void turn(World& world, TimelineCounts& counts, WarnOnce& warnings);

    TimelineClock clock;
    bool resolved = false; ///< as far as is known

private:
    void refuse(std::size_t target, std::string_view component, WarnOnce& warnings);
    void show_track(World& world, std::size_t track, TimelineCounts& counts, WarnOnce& warnings);
    void show_path(World& world, std::size_t path, TimelineCounts& counts, WarnOnce& warnings);

    std::shared_ptr<const TimelineDocument> document_;
    std::vector<TrackWriter> writers_; ///< by track
    std::vector<Entity> targets_;      ///< by target of the document
    std::vector<std::uint32_t> cursors_, path_cursors_;
    std::vector<glm::dvec4> values_;
    std::unordered_set<std::string> comes_and_goes_; ///< names of what actions make and destroy
};

} // namespace hachure
