#include "walk.h"

#include <hachure/components/animation.h>
#include <hachure/components/camera.h>
#include <hachure/components/compose.h>
#include <hachure/components/light.h>
#include <hachure/components/transform.h>
#include <hachure/runtime/ecs/time.h>
#include <hachure/samples/common/walking_figure.h>
#include <hachure/systems/model/spawn_model.h>

#include <glm/gtc/constants.hpp>
#include <glm/gtc/quaternion.hpp>

#include <cmath>

#include "hills.h"

namespace hill_walk {

using namespace hachure;

namespace {

constexpr float figure_height = 1.8f; // metres

/// Resource: whether figures walk.
struct Walking {
    bool on = true;
};

void place(Transform& transform, const Walker& walker) {
    const double x = path_radius * std::cos(walker.at), z = path_radius * std::sin(walker.at);
    transform.translation = {x, ground_height(x, z), z};
    // Figures look along +Z; the path leads towards (-sin, cos).
    transform.rotation = glm::angleAxis(static_cast<float>(-walker.at), glm::vec3(0.0f, 1.0f, 0.0f));
}

void walk(Query<Transform, Walker> figures, const Walking& walking, const Time& time) {
    if (!walking.on || time.delta == 0.0) return; // what is not written to is not drawn again
    for (auto [entity, transform, walker] : figures) {
        walker.at += walker.speed / path_radius * time.delta;
        place(transform, walker);
    }
}

} // namespace

HillWalk::HillWalk(App& app, const std::vector<std::string>& files, Canvas canvas) : world_(app.world()) {
    world_.set_resource(Walking{});
    app.add_system(Stage::script, "hill_walk.walk", walk);
    add_ground();
    add_figure(first_figure, files.empty() ? "" : files[0]);
    add_figure(second_figure, files.size() < 2 ? "" : files[1]);
    add_view(canvas);
    wear(ground, 0);
    wear(first_figure, 0);
    wear(second_figure, 1);
}

void HillWalk::add_ground() {
    SpawnedModel model = spawn_model(world_, hills_model());
    parts_[ground] = {model.root, std::move(model.surfaces)};
}

void HillWalk::add_figure(Part part, const std::string& file) {
    const bool first = part == first_figure;
    const float height = first || !file.empty() ? figure_height : 0.85f * figure_height;
    SpawnedModel model = samples::spawn_walking_figure(world_, file, height, first ? 1.0f : 1.35f);
    const Walker walker{.at = glm::half_pi<double>() + (first ? -0.1 : -0.55), .speed = 0.73 * double(height)};
    place(world_.get_mutable<Transform>(model.root), walker);
    world_.add(model.root, walker);
    parts_[part] = {model.root, std::move(model.surfaces)};
}

void HillWalk::add_view(Canvas canvas) {
    world_.set_resource(canvas);
    const glm::vec3 eye(2.5f, 5.5f, 14.5f), middle(0.0f, 0.2f, 2.0f);
    camera_ = world_.create_with(
        Transform{.translation = eye, .rotation = glm::quatLookAt(glm::normalize(middle - eye), glm::vec3(0, 1, 0))},
        Camera{.yfov = 0.55f, .znear = 0.2f}, Compose{.background = {0.86f, 0.9f, 0.95f}});
    const glm::vec3 light(-0.7f, -0.6f, -0.4f);
    world_.create_with(Transform{.rotation = glm::quatLookAt(glm::normalize(light), glm::vec3(0, 1, 0))}, Light{});
}

void HillWalk::wear(Part part, std::size_t look) {
    const auto looks = part == ground ? ground_looks() : figure_looks();
    Dressed& dressed = parts_[part];
    for (const Entity brush : brushes(part)) world_.destroy(brush);
    dressed.look_number = look % looks.size();
    dressed.look = looks[dressed.look_number].name;
    for (const Entity surface : dressed.surfaces) world_.add(surface, looks[dressed.look_number].tones);
    // An entity for each brush, below what it paints on.
    for (const ImplicitBrush& brush : looks[dressed.look_number].brushes)
        world_.set_parent(world_.create_with(ImplicitBrush(brush)), dressed.root);
}

void HillWalk::next_look(Part part) { wear(part, parts_[part].look_number + 1); }

std::vector<Entity> HillWalk::brushes(Part part) const {
    std::vector<Entity> result;
    for (const Entity child : world_.children(parts_[part].root))
        if (world_.has<ImplicitBrush>(child)) result.push_back(child);
    return result;
}

void HillWalk::set_walking(bool on) {
    world_.resource_mutable<Walking>().on = on;
    for (auto [entity, animation] : world_.query<Animation>()) animation.playing = on;
}

bool HillWalk::walking() const { return std::as_const(world_).resource<Walking>().on; }

} // namespace hill_walk
