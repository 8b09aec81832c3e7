#pragma once

#include <glm/vec2.hpp>

#include <cstdint>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace hachure {

enum class InputKind : std::uint8_t {
    key_down,
    key_up,
    button_down, ///< of a pointer
    button_up,
    pointer_move,
    scroll,
};

/// Something that a person did. Keys are called as on a US keyboard, in lower case: "a", "1", "space", "left", "f1",
/// "left_shift", "escape", "enter"; buttons "left", "right", "middle".
struct InputEvent {
    InputKind kind = InputKind::key_down;
    std::string name;   ///< of the key or button
    glm::vec2 at{0.0f}; ///< pointer_move: pixels of the picture from its upper left corner; scroll: steps right and up

    friend bool operator==(const InputEvent&, const InputEvent&) = default;
};

/// Resource: what people do. Whoever owns the window, or plays a recording, calls `take` before each frame; systems
/// read it.
struct Input {
    std::set<std::string, std::less<>> keys;    ///< held down
    std::set<std::string, std::less<>> buttons; ///< held down
    glm::vec2 pointer{0.0f};                    ///< pixels, as InputEvent::at
    glm::vec2 pointer_delta{0.0f};              ///< moved in this frame
    glm::vec2 scroll{0.0f};                     ///< in this frame
    std::vector<InputEvent> events;             ///< of this frame, in order

    /// Begins a frame with these events. A key that goes down while it is down, or up while it is up, is no event.
    void take(std::span<const InputEvent> frame_events);

    [[nodiscard]] bool is_down(std::string_view key) const { return keys.contains(key); }

    /// Whether the key went down in this frame.
    [[nodiscard]] bool was_pressed(std::string_view key) const;
    [[nodiscard]] bool was_released(std::string_view key) const;
};

} // namespace hachure
