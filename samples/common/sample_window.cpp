#include <hachure/samples/common/sample_window.h>

#include <GLFW/glfw3.h>

#include <algorithm>
#include <utility>

namespace samples {

using namespace hachure;

SampleWindow::SampleWindow(const std::string& title, Canvas size)
    : context_(gpu::make_context(
          {.backend = gpu::Backend::glfw, .width = size.width, .height = size.height, .title = title})),
      window_(context_->window()), now_(glfwGetTime()) {
    glfwGetCursorPos(window_, &pointer_.x, &pointer_.y);
    glfwSetWindowUserPointer(window_, &pending_);
    glfwSetScrollCallback(window_, [](GLFWwindow* window, double, double up) {
        static_cast<Hand*>(glfwGetWindowUserPointer(window))->scroll += static_cast<float>(up);
    });
    glfwSetKeyCallback(window_, [](GLFWwindow* window, int key, int, int action, int) {
        Hand& hand = *static_cast<Hand*>(glfwGetWindowUserPointer(window));
        if (action == GLFW_PRESS) hand.keys.push_back(key);
        if (action == GLFW_REPEAT) hand.repeats.push_back(key);
        if (key == GLFW_KEY_ESCAPE) glfwSetWindowShouldClose(window, GLFW_TRUE);
    });
}

bool SampleWindow::next_frame(World& world) {
    context_->poll_events();
    hand_ = std::exchange(pending_, {});
    follow_pointer();
    follow_clock();
    follow_size(world);
    return !glfwWindowShouldClose(window_);
}

void SampleWindow::set_title(const std::string& title) { glfwSetWindowTitle(window_, title.c_str()); }

void SampleWindow::follow_pointer() {
    const glm::dvec2 before = pointer_;
    glfwGetCursorPos(window_, &pointer_.x, &pointer_.y);
    if (glfwGetMouseButton(window_, GLFW_MOUSE_BUTTON_LEFT) == GLFW_PRESS) hand_.drag = glm::vec2(pointer_ - before);
}

void SampleWindow::follow_clock() {
    const double before = now_;
    now_ = glfwGetTime();
    seconds_ = now_ - before;
}

void SampleWindow::follow_size(World& world) {
    Canvas canvas{};
    glfwGetFramebufferSize(window_, &canvas.width, &canvas.height);
    // A window that is minimised has no size, and a Canvas that is set again draws everything again.
    if (canvas.width == 0 || canvas.height == 0) return;
    const Canvas* old = std::as_const(world).find_resource<Canvas>();
    if (!old || !(*old == canvas)) world.set_resource(canvas);
}

int passes_run(Renderer& renderer) {
    return static_cast<int>(std::ranges::count(renderer.pass_stats(), gpu::PassState::run, &gpu::PassStats::state));
}

} // namespace samples
