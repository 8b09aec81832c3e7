#include <hachure/components/transform.h>
#include <hachure/systems/timeline/look_at.h>
#include <hachure/systems/timeline/timeline_player.h>

#include <glm/vec3.hpp>

#include <algorithm>
#include <utility>

namespace hachure {
namespace {

/// Whether one of the names in a path is one of these.
bool names_any(std::string_view path, const std::unordered_set<std::string>& names) {
    return std::ranges::any_of(names, [&](const std::string& name) {
        const std::size_t at = path.find(name);
        const std::size_t end = at + name.size();
        return at != path.npos && (at == 0 || path[at - 1] == '/') && (end == path.size() || path[end] == '/');
    });
}

} // namespace

TimelinePlayer::TimelinePlayer(const TypeRegistry& types, std::shared_ptr<const TimelineDocument> document)
    : document_(std::move(document)) {
    for (const TimelineTrack& track : document_->tracks) writers_.emplace_back(types, track);
    cursors_.resize(document_->tracks.size());
    values_.resize(document_->tracks.size());
    path_cursors_.resize(document_->paths.size());
    for (const TimelineAction& action : document_->actions) {
        if (action.kind == TimelineActionKind::destroy) comes_and_goes_.insert(action.on);
        if (action.kind != TimelineActionKind::spawn) continue;
        comes_and_goes_.insert(action.name.empty() ? action.what : action.name);
    }
}

void TimelinePlayer::resolve(const World& world, Entity carrier, TimelineTargets& targets, WarnOnce& warnings) {
    targets.resolve(world, carrier, *document_, targets_);
    resolved = true;
    for (std::size_t i = 0; i < targets_.size(); ++i)
        if (const std::string& path = document_->targets[i]; !targets_[i] && !names_any(path, comes_and_goes_))
            warnings.say("timeline: there is no entity '" + path + "'");
}

void TimelinePlayer::refuse(std::size_t target, std::string_view component, WarnOnce& warnings) {
    const std::string& path = document_->targets[target];
    if (targets_[target])
        warnings.say("timeline: '" + (path.empty() ? std::string("its own entity") : path) + "' has no component '" +
                     std::string(component) + "'");
}

void TimelinePlayer::show_track(World& world, std::size_t track, TimelineCounts& counts, WarnOnce& warnings) {
    const TimelineTrack& moved = document_->tracks[track];
    const Entity entity = targets_[moved.target];
    if (!entity) return;
    TrackWrite result = TrackWrite::same;
    if (moved.choices.empty()) {
        result = writers_[track].write_numbers(world, entity, values_[track]);
    } else {
        const TimelineChoice& choice = moved.choices[static_cast<std::size_t>(values_[track].x)];
        result = choice.target == no_timeline_target
                     ? writers_[track].write_choice(world, entity, choice.value)
                     : writers_[track].write_choice(world, entity, FieldValue(targets_[choice.target]));
    }
    if (result == TrackWrite::written) ++counts.written;
    if (result == TrackWrite::refused) refuse(moved.target, moved.component, warnings);
}

void TimelinePlayer::show_path(World& world, std::size_t path, TimelineCounts& counts, WarnOnce& warnings) {
    const TimelinePath& moved = document_->paths[path];
    const Entity entity = targets_[moved.target];
    if (!moved.path || !entity) return;
    const glm::vec3 place(animation::place_on(*moved.path, clock.place, path_cursors_[path]));
    const Transform* transform = world.find<Transform>(entity);
    if (!transform) return refuse(moved.target, "transform", warnings);
    if (transform->translation == place) return;
    world.find_mutable<Transform>(entity)->translation = place;
    ++counts.written;
}

void TimelinePlayer::show(World& world, TimelineCounts& counts, WarnOnce& warnings) {
    animation::SampleTracksJob job{&document_->keys, clock.place, cursors_, values_};
    job.validate();
    job.run();
    counts.tracks += values_.size();
    for (std::size_t i = 0; i < document_->tracks.size(); ++i) show_track(world, i, counts, warnings);
    for (std::size_t i = 0; i < document_->paths.size(); ++i) show_path(world, i, counts, warnings);
}

void TimelinePlayer::turn(World& world, TimelineCounts& counts, WarnOnce& warnings) {
    for (const TimelinePath& path : document_->paths) {
        const Entity entity = targets_[path.target];
        if (!entity || (!path.look_at_place && path.look_at == no_timeline_target)) continue;
        const Entity seen = path.look_at_place ? Entity::null : targets_[path.look_at];
        if (!path.look_at_place && !seen) continue;
        if (!world.has<Transform>(entity)) {
            refuse(path.target, "transform", warnings);
            continue;
        }
        const glm::dvec3 place = path.look_at_place ? glm::dvec3(*path.look_at_place) : place_in_world(world, seen);
        if (turn_to(world, entity, place)) ++counts.written;
    }
}

} // namespace hachure
