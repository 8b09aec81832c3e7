#include "day.h"

#include <hachure/components/animation.h>
#include <hachure/components/camera.h>
#include <hachure/components/compose.h>
#include <hachure/components/edge_lines.h>
#include <hachure/components/light.h>
#include <hachure/components/toon.h>
#include <hachure/components/transform.h>
#include <hachure/runtime/ecs/time.h>
#include <hachure/samples/common/walking_figure.h>
#include <hachure/systems/model/spawn_model.h>

#include <glm/gtc/constants.hpp>
#include <glm/gtc/quaternion.hpp>

#include <cmath>
#include <utility>

#include "dunes.h"
#include "looks.h"

namespace sun_walk {

using namespace hachure;

namespace {

constexpr float figure_height = 1.8f; // metres

/// Resource: what moves.
struct Moving {
    bool figure = true, sun = true;
};

void place(Transform& transform, const Walker& walker) {
    const double x = path_radius * std::cos(walker.at), z = path_radius * std::sin(walker.at);
    transform.translation = {x, dune_height(x, z), z};
    // Figures look along +Z; the path leads towards (-sin, cos).
    transform.rotation = glm::angleAxis(static_cast<float>(-walker.at), glm::vec3(0.0f, 1.0f, 0.0f));
}

/// Light shines along -Z of its entity: from east over the top, which leans south, to west.
void place(Transform& transform, const Sun& sun) {
    const float c = static_cast<float>(std::cos(sun.at)), s = static_cast<float>(std::sin(sun.at));
    const glm::vec3 towards(c, s * std::cos(Sun::lean), s * std::sin(Sun::lean));
    transform.rotation = glm::quatLookAt(-towards, glm::vec3(0.0f, -std::sin(Sun::lean), std::cos(Sun::lean)));
}

void walk(Query<Transform, Walker> figures, const Moving& moving, const Time& time) {
    if (!moving.figure || time.delta == 0.0) return; // what is not written to is not drawn again
    for (auto [entity, transform, walker] : figures) {
        walker.at += walker.speed / path_radius * time.delta;
        place(transform, walker);
    }
}

void shine(Query<Transform, Sun> suns, const Moving& moving, const Time& time) {
    if (!moving.sun || time.delta == 0.0) return;
    for (auto [entity, transform, sun] : suns) {
        sun.at = std::fmod(sun.at + glm::two_pi<double>() * time.delta / sun.day_seconds, glm::two_pi<double>());
        place(transform, sun);
    }
}

/// Amplitudes are over a model's size: the dunes' is that of many figures.
ShadeStrokes on_ground(ShadeStrokes strokes) {
    for (float* length : {&strokes.amplitude, &strokes.min_amplitude, &strokes.max_amplitude}) *length *= 0.35f;
    strokes.cells = 8000;
    return strokes;
}

} // namespace

Day::Day(App& app, const std::string& file, Canvas canvas) : world_(app.world()) {
    world_.set_resource(Moving{});
    app.add_system(Stage::script, "sun_walk.walk", walk);
    app.add_system(Stage::script, "sun_walk.shine", shine).after("sun_walk.walk");
    add_ground();
    add_figure(file);
    add_view(canvas);
    wear(0);
}

void Day::add_ground() { ground_ = spawn_model(world_, dunes_model()).surfaces; }

void Day::add_figure(const std::string& file) {
    SpawnedModel model = samples::spawn_walking_figure(world_, file, figure_height, 1.1f);
    figure_ = model.root;
    const Walker walker{.at = 0.8, .speed = 0.73 * double(figure_height)};
    place(world_.get_mutable<Transform>(figure_), walker);
    world_.add(figure_, walker);
    body_ = std::move(model.surfaces);
}

void Day::add_view(Canvas canvas) {
    world_.set_resource(canvas);
    const glm::vec3 eye(0.5f, 3.6f, 8.6f), middle(0.1f, 0.55f, 0.3f);
    camera_ = world_.create_with(
        Transform{.translation = eye, .rotation = glm::quatLookAt(glm::normalize(middle - eye), glm::vec3(0, 1, 0))},
        Camera{.yfov = 0.5f, .znear = 0.2f}, Compose{});
    sun_ = world_.create_with(Transform{}, Light{}, Sun{});
    place_sun(Sun{}.at);
}

void Day::wear(std::size_t look) {
    look_ = look % looks().size();
    const Look& worn = looks()[look_];
    for (const std::vector<Entity>* part : {&ground_, &body_})
        for (const Entity surface : *part) {
            world_.add(surface, part == &ground_ ? on_ground(worn.strokes) : worn.strokes);
            world_.add(surface, worn.tones);
            world_.add(surface, EdgeLines{.width = 1.2f, .color = worn.strokes.color});
        }
    world_.get_mutable<Compose>(camera_).background = worn.background;
}

std::string_view Day::look() const { return looks()[look_].name; }

void Day::next_look() { wear(look_ + 1); }

void Day::set_walking(bool on) {
    world_.resource_mutable<Moving>().figure = on;
    for (auto [entity, animation] : world_.query<Animation>()) animation.playing = on;
}

bool Day::walking() const { return world_.resource<Moving>().figure; }

void Day::set_sun_moving(bool on) { world_.resource_mutable<Moving>().sun = on; }

bool Day::sun_moving() const { return world_.resource<Moving>().sun; }

void Day::place_sun(double at) {
    Sun& sun = world_.get_mutable<Sun>(sun_);
    sun.at = at;
    place(world_.get_mutable<Transform>(sun_), sun);
}

} // namespace sun_walk
