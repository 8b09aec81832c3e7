#include <hachure/components/animation_events.h>
#include <hachure/systems/animation/animation_parts.h>
#include <hachure/systems/animation/part_source.h>

#include <algorithm>

namespace hachure {
namespace {

using animation::TimelineEvent;
using assets::JsonValue;
using nlohmann::json;

constexpr const char* events_name = "animation_events";
constexpr std::size_t most_events = 100'000;

std::vector<TimelineEvent> read_events(const JsonValue& value) {
    std::vector<TimelineEvent> events;
    const std::size_t count = value.array_size(most_events);
    for (std::size_t i = 0; i < count; ++i) {
        const JsonValue event = value.at(i);
        if (event.array_size(2) != 2) event.fail("an event is [time, name]");
        if (event.at(1).string().empty()) event.at(1).fail("the name is empty");
        events.push_back({event.at(0).number(0, 1e9), event.at(1).string()});
    }
    return events;
}

json write_events(const AnimationEvents& events) {
    json result = json::object();
    for (const auto& [clip, list] : events.by_clip) {
        json& out = result[clip] = json::array();
        for (const TimelineEvent& event : list) out.push_back({event.time, event.name});
    }
    return result;
}

/// How long a clip is; where the model has none of that name, as long as its events last.
double duration_of(const animation::ClipSet* clips, const std::string& clip, const std::vector<TimelineEvent>& events) {
    if (const auto found = clips ? animation::find_clip(*clips, clip) : std::nullopt)
        return clips->clips[*found].duration;
    double last = 0.0;
    for (const TimelineEvent& event : events) last = std::max(last, event.time);
    return last;
}

void add_events(World& world, Entity entity, const ScenePartSource& source) {
    const JsonValue value(source.text, source.pointer, source.value);
    if (!source.value.is_object()) value.fail("the events of clips are an object");
    const animation::ClipSet* clips = clips_of(world, entity);
    AnimationEvents events;
    for (const auto& [clip, list] : source.value.items()) {
        const JsonValue place = value.at(clip);
        std::vector<TimelineEvent> read = read_events(place);
        std::vector<std::string> moved;
        const double duration = duration_of(clips, clip, read);
        events.by_clip[clip] = animation::sort_events(std::move(read), duration, moved);
        if (clips && !animation::find_clip(*clips, clip))
            moved.push_back("the model has no clip " + assets::in_quotes(clip));
        for (const std::string& warning : moved)
            source.warnings.push_back(source.text.subject() + ": " + warning + " (" + place.where() + ")");
    }
    remember_source(world, entity, events_name, source.value, write_events(events));
    world.add(entity, std::move(events));
}

std::optional<json> events_json(const World& world, Entity entity) {
    const AnimationEvents* events = world.find<AnimationEvents>(entity);
    if (!events) return std::nullopt;
    return as_it_was(world, entity, events_name, write_events(*events));
}

const char* const events_schema_text = R"json({
  "type": "object", "description": "by clip: what happens when", "additionalProperties": {
    "type": "array", "maxItems": 100000, "items": {
      "type": "array", "minItems": 2, "maxItems": 2,
      "prefixItems": [{"type": "number", "minimum": 0}, {"type": "string", "minLength": 1}]}}
})json";

} // namespace

ScenePart animation_events_part() {
    return {events_name, "what happens at moments of a model's clips", json::parse(events_schema_text), add_events,
            events_json};
}

} // namespace hachure
