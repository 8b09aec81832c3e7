#include <hachure/runtime/assets/path_rules.h>
#include <hachure/runtime/error.h>
#include <hachure/systems/timeline/read_timeline.h>
#include <hachure/systems/timeline/timeline_reading.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <numeric>
#include <utility>

namespace hachure {
namespace {

using assets::JsonText;
using assets::JsonValue;

constexpr double latest = 1e9; // seconds, as Timeline::time

void read_start(const JsonValue& value, TimelineStart& start) {
    if (const auto playing = value.find("playing")) start.playing = playing->flag();
    if (const auto speed = value.find("speed")) start.speed = static_cast<float>(speed->number(-1000, 1000));
    if (const auto time = value.find("time")) start.time = time->number(0, latest);
    if (const auto repeat = value.find("repeat"))
        start.repeat = static_cast<Repeat>(repeat->option({"once", "loop", "ping_pong"}));
}

void read_actions(TimelineReading& reading, const JsonValue& value) {
    std::vector<std::pair<double, TimelineAction>> actions;
    const std::size_t count = value.array_size(most_timeline_actions);
    for (std::size_t i = 0; i < count; ++i) actions.push_back(read_action(reading, value.at(i)));
    std::ranges::stable_sort(actions, {}, &std::pair<double, TimelineAction>::first);
    for (auto& [time, action] : actions) {
        reading.document.moments.push_back({time, {}});
        reading.document.actions.push_back(std::move(action));
    }
}

/// The end, as it is said or as what comes last has it.
void read_duration(TimelineReading& reading, const JsonValue& value) {
    TimelineDocument& document = reading.document;
    document.duration = reading.last;
    const auto given = value.find("duration");
    if (!given) return;
    document.duration = given->number(0, latest);
    if (!document.moments.empty() && document.moments.back().time > document.duration)
        given->fail(fmt::format("an action lies behind the end, at {} s", document.moments.back().time));
    if (reading.last > document.duration)
        reading.warnings.push_back(fmt::format("{}: keys behind the end, up to {} s, are never reached ({})",
                                               given->text().subject(), reading.last, given->where()));
}

TimelineDocument read_inline(const JsonValue& value, const TypeRegistry& types, std::vector<std::string>& warnings) {
    value.require_keys(
        {"hachure_timeline", "doc", "duration", "repeat", "speed", "playing", "time", "tracks", "actions", "paths"});
    if (const auto version = value.find("hachure_timeline")) (void)version->number(1, 1);
    if (const auto doc = value.find("doc")) (void)doc->string();
    TimelineReading reading{types, warnings, {}, 0.0, 0, {}, {}};
    read_start(value, reading.document.start);
    const auto each = [&](const char* key, std::size_t most, auto read) {
        const auto list = value.find(key);
        const std::size_t count = list ? list->array_size(most) : 0;
        for (std::size_t i = 0; i < count; ++i) read(reading, list->at(i));
    };
    each("tracks", most_timeline_tracks, read_track);
    each("paths", most_timeline_tracks, read_path);
    if (const auto actions = value.find("actions")) read_actions(reading, *actions);
    read_duration(reading, value);
    return std::move(reading.document);
}

/// What a file says, with what stands beside its name instead of its own.
TimelineDocument read_file(const JsonValue& value, const TypeRegistry& types, const std::filesystem::path& folder,
                           std::vector<std::string>& warnings) {
    value.require_keys({"file", "repeat", "speed", "playing", "time"});
    const JsonValue name = value.at("file");
    std::string escaped; // path rules are those of URIs
    for (const char c : name.string()) escaped += c == '%' ? "%25" : std::string(1, c);
    std::filesystem::path file;
    try {
        file = assets::resolve_beside(folder / "timeline", escaped);
    } catch (const Error&) {
        name.fail(assets::in_quotes(name.string()) + " is no file in the folder of this one");
    }
    const JsonText text = JsonText::read(file);
    TimelineDocument document = read_inline(JsonValue(text), types, warnings);
    read_start(value, document.start);
    return document;
}

} // namespace

std::uint32_t TimelineReading::target(const std::string& path) {
    const auto [at, is_new] = targets.try_emplace(path, static_cast<std::uint32_t>(document.targets.size()));
    if (is_new) document.targets.push_back(path);
    return at->second;
}

double read_time(TimelineReading& reading, const JsonValue& value) {
    const double time = value.number(0, latest);
    reading.last = std::max(reading.last, time);
    return time;
}

void count_keys(TimelineReading& reading, const JsonValue& value, std::size_t keys) {
    reading.keys += keys;
    if (reading.keys > most_timeline_keys)
        value.fail(fmt::format("the timeline has more than {} keys", most_timeline_keys));
}

std::shared_ptr<const TimelineDocument> read_timeline(const JsonValue& value, const TypeRegistry& types,
                                                      const std::filesystem::path& folder,
                                                      std::vector<std::string>& warnings) {
    if (!value.json().is_object()) value.fail("a timeline is an object");
    auto document =
        std::make_shared<TimelineDocument>(value.json().contains("file") ? read_file(value, types, folder, warnings)
                                                                         : read_inline(value, types, warnings));
    document->source = std::make_shared<const nlohmann::json>(value.json());
    return document;
}

} // namespace hachure
