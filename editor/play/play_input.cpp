#include <hachure/editor/play/play_input.h>
#include <hachure/runtime/assets/atomic_file.h>

#include <array>
#include <cmath>
#include <utility>

namespace hachure::play {
namespace {

struct KindName {
    InputKind kind;
    const char* name;
    bool has_place; ///< [x, y], not the name of a key or button
};

constexpr std::array<KindName, 6> input_kinds{{{InputKind::key_down, "key_down", false},
                                               {InputKind::key_up, "key_up", false},
                                               {InputKind::button_down, "button_down", false},
                                               {InputKind::button_up, "button_up", false},
                                               {InputKind::pointer_move, "pointer_move", true},
                                               {InputKind::scroll, "scroll", true}}};

glm::vec2 parse_place(JsonObject& object, const std::string& key) {
    const nlohmann::json& value = object.at(key);
    if (!value.is_array() || value.size() != 2 || !value[0].is_number() || !value[1].is_number())
        object.fail(key, key + " is no [x, y]");
    const glm::vec2 at(value[0].get<float>(), value[1].get<float>());
    if (!std::isfinite(at.x) || !std::isfinite(at.y)) object.fail(key, key + " is too large");
    return at;
}

std::pair<std::int64_t, InputEvent> parse_event(const assets::JsonText& text, const std::string& pointer,
                                                const nlohmann::json& value) {
    JsonObject object(text, pointer, value);
    const std::int64_t frame = object.integer("frame", 0, max_frames - 1);
    InputEvent event;
    int found = 0;
    for (const KindName& kind : input_kinds) {
        if (!object.has(kind.name)) continue;
        ++found;
        event.kind = kind.kind;
        if (kind.has_place)
            event.at = parse_place(object, kind.name);
        else
            event.name = object.text(kind.name);
    }
    if (found != 1)
        text.fail(pointer, "an event is one of key_down, key_up, button_down, button_up, pointer_move, scroll");
    object.finish();
    return {frame, event};
}

nlohmann::json event_json(std::int64_t frame, const InputEvent& event) {
    nlohmann::json result{{"frame", frame}};
    for (const KindName& kind : input_kinds) {
        if (kind.kind != event.kind) continue;
        if (kind.has_place)
            result[kind.name] = {event.at.x, event.at.y};
        else
            result[kind.name] = event.name;
    }
    return result;
}

} // namespace

InputByFrame parse_input(const assets::JsonText& text, const std::string& pointer, const nlohmann::json& events) {
    if (!events.is_array()) text.fail(pointer, "is no array of events");
    InputByFrame result;
    for (std::size_t i = 0; i < events.size(); ++i) {
        auto [frame, event] = parse_event(text, child_pointer(pointer, i), events[i]);
        result[frame].push_back(std::move(event));
    }
    return result;
}

InputByFrame read_recording(const std::filesystem::path& file) {
    const assets::JsonText text = assets::JsonText::read(file);
    JsonObject object(text, "", text.root());
    object.integer("hachure_input", 1, 1);
    InputByFrame result = parse_input(text, "/events", object.at("events"));
    object.finish();
    return result;
}

void write_recording(const std::filesystem::path& file, const InputByFrame& input) {
    std::string text = "{\n  \"hachure_input\": 1,\n  \"events\": [";
    const char* separator = "\n";
    for (const auto& [frame, events] : input)
        for (const InputEvent& event : events) {
            text += separator + ("    " + event_json(frame, event).dump());
            separator = ",\n";
        }
    text += "\n  ]\n}\n";
    assets::write_file_atomically(file, std::as_bytes(std::span(text.data(), text.size())));
}

} // namespace hachure::play
