#pragma once

#include <hachure/components/animation.h>
#include <hachure/runtime/animation/smooth_path.h>
#include <hachure/runtime/animation/timeline.h>
#include <hachure/runtime/animation/timeline_events.h>
#include <hachure/runtime/ecs/field_info.h>
#include <hachure/runtime/ecs/reflect.h>

#include <glm/vec3.hpp>
#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace hachure {

/// No target of a TimelineDocument.
inline constexpr std::uint32_t no_timeline_target = 0xffffffff;

/// A value that is not made of numbers: a flag, a whole number, a text, an option, an entity.
struct TimelineChoice {
    FieldValue value;
    std::uint32_t target = no_timeline_target; ///< of an entity's handle: which; `value` is null then
};

/// What a track of the document moves: a field, or an element of it.
struct TimelineTrack {
    std::uint32_t target = 0;            ///< into TimelineDocument::targets
    std::string component, field;        ///< reflected names
    std::int32_t element = -1;           ///< of a vector or colour, 0 to 3; -1 for all of the field
    std::vector<TimelineChoice> choices; ///< of a track that is taken in steps: what its numbers mean
};

/// An entity that moves along a curve, or turns to look at something, or both.
struct TimelinePath {
    std::uint32_t target = 0;
    std::optional<animation::SmoothPath> path;  ///< of Transform::translation
    std::uint32_t look_at = no_timeline_target; ///< the entity that -Z points to
    std::optional<glm::vec3> look_at_place;     ///< or this place of the world
};

enum class TimelineActionKind : std::uint8_t {
    spawn,   ///< `what`, a file or an entity, as a new entity called `name` below `on`
    destroy, ///< `on`, with all below it
    parent,  ///< `on` becomes a child of `what`; a root when `what` is empty
    clip,    ///< `on` plays the clip `what` (Animation)
    state,   ///< `parameters` of the state machine of `on` (AnimationStates)
    camera,  ///< `on` is the one that draws (Camera::active), no other
    event,   ///< a SceneEvent `what` about `on`
};

/// Something that a timeline does at a moment. Entities are named by paths as NameIndex has them, and looked for when
/// the moment has come.
struct TimelineAction {
    TimelineActionKind kind = TimelineActionKind::event;
    std::string what, on, name;
    std::vector<std::pair<std::string, float>> parameters;
};

/// What a timeline's fields were when it was read.
struct TimelineStart {
    bool playing = true;
    float speed = 1.0f;
    double time = 0.0;
    Repeat repeat = Repeat::once;
};

/// What a timeline does, as it was read from a file; shared by all who play it, and constant.
struct TimelineDocument {
    double duration = 0.0; ///< seconds
    /// Paths of names of entities, each once: below the entity with the timeline, or else anywhere; empty for that
    /// entity itself.
    std::vector<std::string> targets;
    animation::TrackSet keys;                      ///< one track for each of `tracks`
    std::vector<TimelineTrack> tracks;             ///< no two have the same target, field and element
    std::vector<TimelinePath> paths;               ///< entities that move along curves
    std::vector<animation::TimelineEvent> moments; ///< of the actions, sorted
    std::vector<TimelineAction> actions;           ///< one for each of `moments`
    TimelineStart start;
    std::shared_ptr<const nlohmann::json> source; ///< what it was read from: written again
};

/// Moves fields of entities and makes things happen at their times.
struct Timeline {
    bool playing = true;
    float speed = 1.0f;
    double time = 0.0;
    Repeat repeat = Repeat::once;
    std::shared_ptr<const TimelineDocument> document; ///< null: does nothing
};

inline void reflect(TypeBuilder<Timeline>& type) {
    type.name("timeline").doc("moves fields of entities by keys, and makes things happen at their times");
    type.field("playing", &Timeline::playing).doc("whether time goes on");
    type.field("speed", &Timeline::speed)
        .doc("seconds of the timeline per second; negative plays from the end to the start")
        .range(-1000, 1000);
    type.field("time", &Timeline::time)
        .doc("seconds of the timeline that it has played; setting it jumps there, without what happens on the way")
        .unit("s")
        .range(0, 1e9);
    type.field("repeat", &Timeline::repeat).doc("what comes after the end").options({"once", "loop", "ping_pong"});
}

} // namespace hachure
