#pragma once

#include <hachure/editor/play/play_input.h>

#include <filesystem>
#include <functional>

struct GLFWwindow;

namespace hachure::play {

/// Takes what people do in a window as events, in order. One per window, which outlives it.
class WindowInput {
public:
    /// Listens to the window, whose picture has `picture` pixels.
    WindowInput(GLFWwindow* window, glm::vec2 picture);
    ~WindowInput();
    WindowInput(const WindowInput&) = delete;
    WindowInput& operator=(const WindowInput&) = delete;

    /// What happened since the last call.
    [[nodiscard]] std::vector<InputEvent> take();

    /// As the window's callbacks say it, in GLFW's codes.
    void key(int key, int action);
    void button(int button, int action);
    void move(double x, double y);
    void scroll(double x, double y);

private:
    GLFWwindow* window_;
    glm::vec2 picture_;
    std::vector<InputEvent> events_;
};

/// Shows the scene of a test in a window, frame by frame at the test's rate, and writes what people do to it as a
/// recording when the window is closed or a signal says so. Returns 0. Throws Error when there is no display.
int record(const std::filesystem::path& test, const std::filesystem::path& recording);

} // namespace hachure::play
