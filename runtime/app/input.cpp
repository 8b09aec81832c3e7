#include <hachure/runtime/app/input.h>

#include <algorithm>

namespace hachure {
namespace {

using Names = std::set<std::string, std::less<>>;

/// False when the event changes nothing.
bool hold(Names& names, const std::string& name, bool down) {
    return down ? names.insert(name).second : names.erase(name) > 0;
}

bool apply(Input& input, const InputEvent& event) {
    switch (event.kind) {
    case InputKind::key_down:
        return hold(input.keys, event.name, true);
    case InputKind::key_up:
        return hold(input.keys, event.name, false);
    case InputKind::button_down:
        return hold(input.buttons, event.name, true);
    case InputKind::button_up:
        return hold(input.buttons, event.name, false);
    case InputKind::pointer_move:
        input.pointer_delta += event.at - input.pointer;
        input.pointer = event.at;
        return true;
    case InputKind::scroll:
        input.scroll += event.at;
        return true;
    }
    return false;
}

bool has(const std::vector<InputEvent>& events, InputKind kind, std::string_view name) {
    return std::ranges::any_of(events, [&](const InputEvent& e) { return e.kind == kind && e.name == name; });
}

} // namespace

void Input::take(std::span<const InputEvent> frame_events) {
    pointer_delta = scroll = glm::vec2(0.0f);
    events.clear();
    for (const InputEvent& event : frame_events)
        if (apply(*this, event)) events.push_back(event);
}

bool Input::was_pressed(std::string_view key) const { return has(events, InputKind::key_down, key); }
bool Input::was_released(std::string_view key) const { return has(events, InputKind::key_up, key); }

} // namespace hachure
