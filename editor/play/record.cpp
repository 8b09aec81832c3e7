#include <hachure/editor/interrupt.h>
#include <hachure/editor/play/play_document.h>
#include <hachure/editor/play/played_scene.h>
#include <hachure/editor/play/record.h>
#include <hachure/runtime/error.h>
#include <hachure/systems/capabilities.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <array>
#include <chrono>
#include <cstdio>
#include <memory>
#include <thread>
#include <utility>

namespace hachure::play {
namespace {

constexpr std::array<std::pair<int, const char*>, 40> special_keys{{{GLFW_KEY_SPACE, "space"},
                                                                    {GLFW_KEY_ESCAPE, "escape"},
                                                                    {GLFW_KEY_ENTER, "enter"},
                                                                    {GLFW_KEY_TAB, "tab"},
                                                                    {GLFW_KEY_BACKSPACE, "backspace"},
                                                                    {GLFW_KEY_INSERT, "insert"},
                                                                    {GLFW_KEY_DELETE, "delete"},
                                                                    {GLFW_KEY_RIGHT, "right"},
                                                                    {GLFW_KEY_LEFT, "left"},
                                                                    {GLFW_KEY_DOWN, "down"},
                                                                    {GLFW_KEY_UP, "up"},
                                                                    {GLFW_KEY_PAGE_UP, "page_up"},
                                                                    {GLFW_KEY_PAGE_DOWN, "page_down"},
                                                                    {GLFW_KEY_HOME, "home"},
                                                                    {GLFW_KEY_END, "end"},
                                                                    {GLFW_KEY_LEFT_SHIFT, "left_shift"},
                                                                    {GLFW_KEY_LEFT_CONTROL, "left_control"},
                                                                    {GLFW_KEY_LEFT_ALT, "left_alt"},
                                                                    {GLFW_KEY_LEFT_SUPER, "left_super"},
                                                                    {GLFW_KEY_RIGHT_SHIFT, "right_shift"},
                                                                    {GLFW_KEY_RIGHT_CONTROL, "right_control"},
                                                                    {GLFW_KEY_RIGHT_ALT, "right_alt"},
                                                                    {GLFW_KEY_RIGHT_SUPER, "right_super"},
                                                                    {GLFW_KEY_CAPS_LOCK, "caps_lock"},
                                                                    {GLFW_KEY_PAUSE, "pause"},
                                                                    {GLFW_KEY_PRINT_SCREEN, "print_screen"},
                                                                    {GLFW_KEY_MENU, "menu"},
                                                                    {GLFW_KEY_APOSTROPHE, "'"},
                                                                    {GLFW_KEY_COMMA, ","},
                                                                    {GLFW_KEY_MINUS, "-"},
                                                                    {GLFW_KEY_PERIOD, "."},
                                                                    {GLFW_KEY_SLASH, "/"},
                                                                    {GLFW_KEY_SEMICOLON, ";"},
                                                                    {GLFW_KEY_EQUAL, "="},
                                                                    {GLFW_KEY_LEFT_BRACKET, "["},
                                                                    {GLFW_KEY_BACKSLASH, "\\"},
                                                                    {GLFW_KEY_RIGHT_BRACKET, "]"},
                                                                    {GLFW_KEY_GRAVE_ACCENT, "`"},
                                                                    {GLFW_KEY_KP_ENTER, "keypad_enter"},
                                                                    {GLFW_KEY_NUM_LOCK, "num_lock"}}};

/// As on a US keyboard; empty for keys that have no name.
std::string key_name(int key) {
    if (key >= GLFW_KEY_A && key <= GLFW_KEY_Z) return {static_cast<char>('a' + (key - GLFW_KEY_A))};
    if (key >= GLFW_KEY_0 && key <= GLFW_KEY_9) return {static_cast<char>('0' + (key - GLFW_KEY_0))};
    if (key >= GLFW_KEY_F1 && key <= GLFW_KEY_F25) return "f" + std::to_string(key - GLFW_KEY_F1 + 1);
    if (key >= GLFW_KEY_KP_0 && key <= GLFW_KEY_KP_9) return "keypad_" + std::to_string(key - GLFW_KEY_KP_0);
    for (const auto& [code, name] : special_keys)
        if (code == key) return name;
    return {};
}

std::string button_name(int button) {
    constexpr std::array<const char*, 3> names{"left", "right", "middle"};
    return button >= 0 && button < 3 ? names[static_cast<std::size_t>(button)] : "button_" + std::to_string(button + 1);
}

WindowInput& input_of(GLFWwindow* window) { return *static_cast<WindowInput*>(glfwGetWindowUserPointer(window)); }

std::unique_ptr<gpu::Context> open_window(const PlayDocument& play) {
    gpu::ContextOptions options;
    options.backend = gpu::Backend::glfw;
    options.width = play.size.width;
    options.height = play.size.height;
    options.title = "hachure play --record: " + play.file.filename().string();
    return gpu::make_context(options);
}

bool is_interrupted() {
    try {
        stop_when_interrupted();
        return false;
    } catch (const Error&) {
        return true;
    }
}

} // namespace

WindowInput::WindowInput(GLFWwindow* window, glm::vec2 picture) : window_(window), picture_(picture) {
    glfwSetWindowUserPointer(window, this);
    glfwSetKeyCallback(window, [](GLFWwindow* w, int key, int, int action, int) { input_of(w).key(key, action); });
    glfwSetMouseButtonCallback(window,
                               [](GLFWwindow* w, int button, int action, int) { input_of(w).button(button, action); });
    glfwSetCursorPosCallback(window, [](GLFWwindow* w, double x, double y) { input_of(w).move(x, y); });
    glfwSetScrollCallback(window, [](GLFWwindow* w, double x, double y) { input_of(w).scroll(x, y); });
}

WindowInput::~WindowInput() {
    glfwSetKeyCallback(window_, nullptr);
    glfwSetMouseButtonCallback(window_, nullptr);
    glfwSetCursorPosCallback(window_, nullptr);
    glfwSetScrollCallback(window_, nullptr);
}

std::vector<InputEvent> WindowInput::take() { return std::exchange(events_, {}); }

void WindowInput::key(int key, int action) {
    const std::string name = key_name(key);
    if (name.empty() || action == GLFW_REPEAT) return;
    events_.push_back({action == GLFW_PRESS ? InputKind::key_down : InputKind::key_up, name});
}

void WindowInput::button(int button, int action) {
    events_.push_back({action == GLFW_PRESS ? InputKind::button_down : InputKind::button_up, button_name(button)});
}

void WindowInput::move(double x, double y) {
    int width = 0, height = 0;
    glfwGetWindowSize(window_, &width, &height);
    const glm::vec2 window(std::max(width, 1), std::max(height, 1));
    const glm::vec2 at = glm::vec2(x, y) / window * picture_;
    // Where the pointer was in between does not matter.
    if (!events_.empty() && events_.back().kind == InputKind::pointer_move)
        events_.back().at = at;
    else
        events_.push_back({InputKind::pointer_move, "", at});
}

void WindowInput::scroll(double x, double y) { events_.push_back({InputKind::scroll, "", glm::vec2(x, y)}); }

int record(const std::filesystem::path& test, const std::filesystem::path& recording) {
    App known;
    register_capabilities(known);
    const PlayDocument play = read_play(known.types(), test);
    const std::unique_ptr<gpu::Context> context = open_window(play);
    PlayedScene scene(*context, play);
    WindowInput window(context->window(), glm::vec2(play.size.width, play.size.height));
    const InterruptWatch watch;
    InputByFrame recorded;
    const auto start = std::chrono::steady_clock::now();
    while (!glfwWindowShouldClose(context->window()) && !is_interrupted() && scene.next_frame() < max_frames) {
        context->poll_events();
        std::vector<InputEvent> events = window.take();
        const std::int64_t frame = scene.next_frame();
        scene.step(true, events);
        scene.renderer().present();
        if (!events.empty()) recorded[frame] = std::move(events);
        const std::chrono::duration<double> due(play.fps.time_of(frame + 1));
        std::this_thread::sleep_until(start + std::chrono::duration_cast<std::chrono::steady_clock::duration>(due));
    }
    write_recording(recording, recorded);
    std::printf("%s: %lld frames recorded\n", recording.c_str(), static_cast<long long>(scene.next_frame()));
    std::fflush(stdout); // a signal that closed the window ends the program when it is no longer watched
    return 0;
}

} // namespace hachure::play
