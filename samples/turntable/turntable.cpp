// A model on a turntable; README.md beside this file says what it shows.

#include <hachure/components/camera.h>
#include <hachure/components/edge_lines.h>
#include <hachure/components/gooch.h>
#include <hachure/components/transform.h>
#include <hachure/runtime/app/app.h>
#include <hachure/runtime/assets/read_model.h>
#include <hachure/runtime/error.h>
#include <hachure/runtime/geometry/shapes.h>
#include <hachure/runtime/gpu/context.h>
#include <hachure/runtime/scene/renderer.h>
#include <hachure/systems/camera/camera.h>
#include <hachure/systems/capabilities.h>
#include <hachure/systems/model/spawn_model.h>
#include <hachure/systems/styles/style.h>

#include <GLFW/glfw3.h>
#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>
#include <string_view>

namespace {

using namespace hachure;

assets::Model torus_model() {
    const geometry::Shape shape = geometry::torus(1.0, 0.4, 96, 48);
    assets::Primitive primitive;
    primitive.positions = shape.positions;
    primitive.normals = shape.normals;
    primitive.indices = shape.indices;
    primitive.material = 0;
    assets::Model model;
    model.materials.push_back({.name = "orange", .base_color = {0.7f, 0.25f, 0.08f, 1.0f}});
    model.meshes.push_back({"torus", {std::move(primitive)}, {}});
    model.nodes.push_back({.name = "torus", .mesh = 0});
    model.scenes.push_back({"scene", {0}});
    return model;
}

/// Turns and moves the camera about the point that it looked at in the beginning.
class Orbit {
public:
    explicit Orbit(App& app) : app_(app), camera_(app.world().query<const Camera>().first()) {
        const Transform& transform = app_.world().get<Transform>(camera_);
        distance_ = 3.0f * app_.world().get<Camera>(camera_).znear; // the near plane is half way to the nearest point
        pivot_ = transform.translation - transform.rotation * glm::vec3(0.0f, 0.0f, reach());
    }

    void turn(float yaw, float pitch) {
        Transform& transform = app_.world().get_mutable<Transform>(camera_);
        transform.rotation = glm::normalize(glm::angleAxis(-yaw, glm::vec3(0.0f, 1.0f, 0.0f)) * transform.rotation *
                                            glm::angleAxis(-pitch, glm::vec3(1.0f, 0.0f, 0.0f)));
        place(transform);
    }
    void approach(float factor) {
        zoom_ = std::clamp(zoom_ * factor, 0.3f, 10.0f);
        place(app_.world().get_mutable<Transform>(camera_));
    }

private:
    [[nodiscard]] float reach() const { return distance_ * zoom_; }
    void place(Transform& transform) const {
        transform.translation = pivot_ + transform.rotation * glm::vec3(0.0f, 0.0f, reach());
    }

    App& app_;
    Entity camera_;
    glm::vec3 pivot_{0.0f};
    float distance_ = 1.0f;
    float zoom_ = 1.0f;
};

int passes_run(Renderer& renderer) {
    int count = 0;
    for (const gpu::PassStats& pass : renderer.pass_stats()) count += pass.state == gpu::PassState::run ? 1 : 0;
    return count;
}

void prepare(App& app, const std::string& file, Canvas canvas) {
    app.world().set_resource(canvas);
    const SpawnedModel spawned = spawn_model(app.world(), file.empty() ? torus_model() : assets::read_model(file));
    if (spawned.points.empty()) throw Error(file, "has nothing to draw");
    spawn_framing_camera(app.world(), spawned.points, canvas);
    apply_style(app.world(), app.types(), find_style(app.types(), "gooch"));
}

int run_headless(const std::string& file, int frames) {
    const std::unique_ptr<gpu::Context> context = gpu::make_context();
    App app;
    register_capabilities(app);
    Renderer renderer(app, *context);
    prepare(app, file, {320, 240});
    Orbit orbit(app);
    for (int i = 0; i < frames; ++i) {
        orbit.turn(0.1f, 0.0f);
        renderer.render_frame();
        std::printf("frame %d: %d passes ran\n", i, passes_run(renderer));
    }
    renderer.render_frame();
    const int still = passes_run(renderer);
    std::printf("nothing moved: %d passes ran\n", still);
    return still == 0 ? 0 : 1;
}

struct Input {
    double x = 0.0, y = 0.0, scroll = 0.0;
    bool toggle_lines = false, toggle_equation = false;
};

void follow_input(GLFWwindow* window, Input& input) {
    glfwSetWindowUserPointer(window, &input);
    glfwSetScrollCallback(window, [](GLFWwindow* w, double, double dy) {
        static_cast<Input*>(glfwGetWindowUserPointer(w))->scroll += dy;
    });
    glfwSetKeyCallback(window, [](GLFWwindow* w, int key, int, int action, int) {
        Input& pressed = *static_cast<Input*>(glfwGetWindowUserPointer(w));
        if (action != GLFW_PRESS) return;
        if (key == GLFW_KEY_ESCAPE) glfwSetWindowShouldClose(w, GLFW_TRUE);
        if (key == GLFW_KEY_L) pressed.toggle_lines = true;
        if (key == GLFW_KEY_P) pressed.toggle_equation = true;
    });
}

void apply_toggles(World& world, Input& input) {
    if (input.toggle_lines)
        for (auto [entity, lines] : world.query<EdgeLines>()) lines.width = lines.width > 0.0f ? 0.0f : 2.0f;
    if (input.toggle_equation)
        for (auto [entity, gooch] : world.query<Gooch>()) gooch.printed_equation = !gooch.printed_equation;
    input.toggle_lines = input.toggle_equation = false;
}

int run_window(const std::string& file) {
    gpu::ContextOptions options;
    options.backend = gpu::Backend::glfw;
    options.width = 1024;
    options.height = 768;
    options.title = "turntable";
    const std::unique_ptr<gpu::Context> context = gpu::make_context(options);
    GLFWwindow* window = context->window();
    App app;
    register_capabilities(app);
    Renderer renderer(app, *context);
    prepare(app, file, {options.width, options.height});
    Orbit orbit(app);
    Input input;
    follow_input(window, input);
    glfwGetCursorPos(window, &input.x, &input.y);
    while (!glfwWindowShouldClose(window)) {
        context->poll_events();
        const double old_x = input.x, old_y = input.y;
        glfwGetCursorPos(window, &input.x, &input.y);
        if (glfwGetMouseButton(window, GLFW_MOUSE_BUTTON_LEFT) == GLFW_PRESS && (input.x != old_x || input.y != old_y))
            orbit.turn(static_cast<float>(input.x - old_x) * 0.008f, static_cast<float>(input.y - old_y) * 0.008f);
        if (input.scroll != 0.0) orbit.approach(static_cast<float>(std::pow(0.9, input.scroll)));
        input.scroll = 0.0;
        apply_toggles(app.world(), input);
        Canvas canvas{};
        glfwGetFramebufferSize(window, &canvas.width, &canvas.height);
        if (canvas.width > 0 && canvas.height > 0 && !(canvas == app.world().resource<Canvas>()))
            app.world().set_resource(canvas);
        renderer.render_frame();
        renderer.present();
        glfwSetWindowTitle(window, ("turntable: " + std::to_string(passes_run(renderer)) + " passes ran").c_str());
    }
    return 0;
}

} // namespace

int main(int argc, char** argv) {
    std::string file;
    int headless_frames = 0;
    for (int i = 1; i < argc; ++i) {
        if (std::string_view(argv[i]) == "--headless" && i + 1 < argc)
            headless_frames = std::max(1, std::atoi(argv[++i]));
        else if (argv[i][0] != '-' && file.empty())
            file = argv[i];
        else
            return std::fputs("usage: turntable [MODEL] [--headless FRAMES]\n", stderr), 2;
    }
    try {
        return headless_frames > 0 ? run_headless(file, headless_frames) : run_window(file);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "turntable: error: %s\n", error.what());
        return 1;
    }
}
