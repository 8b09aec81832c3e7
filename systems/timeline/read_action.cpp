#include <hachure/runtime/animation/state_machine.h>
#include <hachure/systems/timeline/read_timeline.h>
#include <hachure/systems/timeline/timeline_reading.h>

#include <limits>

namespace hachure {
namespace {

using assets::JsonValue;

/// A name that has to be one.
std::string read_name(const JsonValue& value) {
    if (value.string().empty()) value.fail("the name is empty");
    return value.string();
}

std::string optional_name(const JsonValue& action, std::string_view key) {
    const auto value = action.find(key);
    return value ? read_name(*value) : std::string();
}

/// "parent": where "to" says; to nobody when it is null.
std::string read_new_parent(const JsonValue& action) {
    const JsonValue to = action.at("to");
    return to.json().is_null() ? std::string() : read_name(to);
}

std::vector<std::pair<std::string, float>> read_parameters(const JsonValue& value) {
    if (!value.json().is_object()) value.fail("parameters of a state machine are an object");
    std::vector<std::pair<std::string, float>> parameters;
    constexpr double most = std::numeric_limits<float>::max();
    for (const auto& [name, number] : value.json().items()) {
        const JsonValue parameter = value.at(name);
        const double given = number.is_boolean() ? (number.get<bool>() ? 1.0 : 0.0) : parameter.number(-most, most);
        parameters.emplace_back(name, static_cast<float>(given));
    }
    return parameters;
}

} // namespace

std::pair<double, TimelineAction> read_action(TimelineReading& reading, const JsonValue& value) {
    if (!value.json().is_object()) value.fail("an action is an object");
    const auto has = [&](const char* key) { return value.json().contains(key); };
    TimelineAction action;
    if (has("spawn")) {
        value.require_keys({"at", "spawn", "name", "parent"});
        action = {TimelineActionKind::spawn,
                  read_name(value.at("spawn")),
                  optional_name(value, "parent"),
                  optional_name(value, "name"),
                  {}};
    } else if (has("destroy")) {
        value.require_keys({"at", "destroy"});
        action = {TimelineActionKind::destroy, {}, read_name(value.at("destroy")), {}, {}};
    } else if (has("parent")) {
        value.require_keys({"at", "parent", "to"});
        action = {TimelineActionKind::parent, read_new_parent(value), read_name(value.at("parent")), {}, {}};
    } else if (has("clip")) {
        value.require_keys({"at", "clip", "on"});
        action = {TimelineActionKind::clip, value.at("clip").string(), optional_name(value, "on"), {}, {}};
    } else if (has("state")) {
        value.require_keys({"at", "state", "on"});
        action = {TimelineActionKind::state, {}, optional_name(value, "on"), {}, read_parameters(value.at("state"))};
    } else if (has("camera")) {
        value.require_keys({"at", "camera"});
        action = {TimelineActionKind::camera, {}, read_name(value.at("camera")), {}, {}};
    } else if (has("event")) {
        value.require_keys({"at", "event", "on"});
        action = {TimelineActionKind::event, read_name(value.at("event")), optional_name(value, "on"), {}, {}};
    } else {
        value.fail("an action has one of spawn, destroy, parent, clip, state, camera, event");
    }
    return {read_time(reading, value.at("at")), std::move(action)};
}

} // namespace hachure
