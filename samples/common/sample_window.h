#pragma once

#include <hachure/runtime/ecs/world.h>
#include <hachure/runtime/gpu/context.h>
#include <hachure/runtime/scene/renderer.h>
#include <hachure/runtime/scene/view.h>

#include <glm/vec2.hpp>

#include <memory>
#include <string>
#include <vector>

struct GLFWwindow;

namespace samples {

/// What a person did in a window since the frame before.
struct Hand {
    glm::vec2 drag{0.0f};     ///< of the pointer with the left button down: pixels right and down
    float scroll = 0.0f;      ///< steps up
    std::vector<int> keys;    ///< GLFW_KEY_... that went down
    std::vector<int> repeats; ///< that are held, once for each time that they repeat
};

/// The window of a sample. Its context is current while it lives; make it before the App. Escape closes it.
class SampleWindow {
public:
    /// Throws Error where there is no display.
    SampleWindow(const std::string& title, hachure::Canvas size);

    [[nodiscard]] hachure::gpu::Context& context() { return *context_; }

    /// Begins a frame: the hand is that of now, and the world's Canvas as large as the window. False when it is closed.
    bool next_frame(hachure::World& world);

    [[nodiscard]] const Hand& hand() const { return hand_; }
    [[nodiscard]] double seconds() const { return seconds_; } ///< since the frame before
    void set_title(const std::string& title);

private:
    void follow_pointer();
    void follow_clock();
    void follow_size(hachure::World& world);

    std::unique_ptr<hachure::gpu::Context> context_;
    GLFWwindow* window_;
    Hand hand_, pending_; ///< `pending_` gathers what callbacks say
    glm::dvec2 pointer_{0.0};
    double now_ = 0.0, seconds_ = 0.0;
};

/// How many passes of the last frame were run: 0 when nothing changed.
[[nodiscard]] int passes_run(hachure::Renderer& renderer);

} // namespace samples
