#include <hachure/components/timeline.h>
#include <hachure/systems/timeline/read_timeline.h>
#include <hachure/systems/timeline/timeline_part.h>
#include <hachure/systems/timeline/timeline_schema.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace hachure {
namespace {

using nlohmann::json;

void read_part(World& world, Entity entity, const ScenePartSource& source) {
    Timeline timeline;
    timeline.document = read_timeline(assets::JsonValue(source.text, source.pointer, source.value), source.types,
                                      source.folder, source.warnings);
    const TimelineStart& start = timeline.document->start;
    timeline.playing = start.playing;
    timeline.speed = start.speed;
    timeline.time = start.time;
    timeline.repeat = start.repeat;
    world.add(entity, std::move(timeline));
}

/// A float as few digits say it: 0.1, and not 0.10000000149011612.
json shortest(float number) { return json::parse(fmt::format("{}", number)); }

/// What was read, with what has changed since.
std::optional<json> write_part(const World& world, Entity entity) {
    const Timeline* timeline = world.find<Timeline>(entity);
    if (!timeline) return std::nullopt;
    const TimelineDocument* document = timeline->document.get();
    const TimelineStart start = document ? document->start : TimelineStart{};
    json result = document && document->source ? *document->source : json::object();
    if (timeline->playing != start.playing) result["playing"] = timeline->playing;
    if (timeline->speed != start.speed) result["speed"] = shortest(timeline->speed);
    if (timeline->time != start.time) result["time"] = timeline->time;
    constexpr const char* repeats[] = {"once", "loop", "ping_pong"};
    if (timeline->repeat != start.repeat) result["repeat"] = repeats[static_cast<std::size_t>(timeline->repeat)];
    return result;
}

} // namespace

ScenePart timeline_part() {
    return {"timeline", "moves fields of entities by keys, and makes things happen at their times", timeline_schema(),
            read_part, write_part};
}

} // namespace hachure
