#include "figure.h"

#include <hachure/components/camera.h>
#include <hachure/components/compose.h>
#include <hachure/components/edge_lines.h>
#include <hachure/components/gooch.h>
#if __has_include(<hachure/components/metal.h>)
#include <hachure/components/metal.h>
#endif
#include <hachure/components/surface.h>
#include <hachure/components/transform.h>
#include <hachure/runtime/error.h>

#include <algorithm>

#include "lettering.h"

using namespace hachure;

namespace {

constexpr glm::vec3 ink(0.03f, 0.03f, 0.04f), paper(1.0f);
constexpr float cell_width = 2.0f, cell_height = 2.3f;  ///< of one copy, in its radii
constexpr float letter_height = 0.082f;                   ///< of a letter, in radii
constexpr float label_place = -1.06f, part_place = 0.13f; ///< above the middle of a cell

void add_lines(World& world, Entity surface, float width) {
    world.add(surface, EdgeLines{.crease_angle = 0.5f, .width = width, .color = ink});
}

void add_metal(World& world, Entity surface, float cool_to_warm) {
#if __has_include(<hachure/components/metal.h>)
    world.add(surface, Metal{.source = MetalSource::around_axis, .cool_to_warm = cool_to_warm});
#else
    world.add(surface, Gooch{.b = 0.3f + 0.1f * cool_to_warm});
#endif
}

} // namespace

const std::array<Look, 4> figure_10 = {
    {{"Phong", [](World& world, Entity surface, float) { world.add(surface, Gooch{.shading = GoochShading::phong}); }},
     {"metal", [](World& world, Entity surface, float) { add_metal(world, surface, 0.0f); }},
     {"metal with edge lines",
      [](World& world, Entity surface, float width) {
          add_metal(world, surface, 0.0f);
          add_lines(world, surface, width);
      }},
     {"metal, cool to warm", [](World& world, Entity surface, float width) {
          add_metal(world, surface, 1.0f);
          add_lines(world, surface, width);
      }}}};

Figure::Figure(App& app, const assets::Model& model, float line_width)
    : app_(app), rotation_(glm::angleAxis(0.34f, glm::vec3(0, 0, -1)) * glm::angleAxis(0.62f, glm::vec3(1, 0, 0)) *
                           glm::angleAxis(0.2f, glm::vec3(0, 1, 0))) {
    World& world = app.world();
    StoredModel stored;
    for (const Look& look : figure_10) {
        Copy copy{spawn_model(world, model, stored), world.create(), lettering_width(look.label)};
        if (copy.model.points.empty()) throw Error("the model", "has nothing to draw");
        for (const Entity surface : copy.model.surfaces) look.dress(world, surface, line_width);
        world.add(copy.label, Transform{});
        world.add(copy.label, Surface{world.resource_mutable<MeshStore>().add(lettering(look.label, ink))});
        copies_.push_back(std::move(copy));
    }
    glm::vec3 low = copies_[0].model.points[0], high = low;
    for (const glm::vec3& point : copies_[0].model.points) {
        low = glm::min(low, point);
        high = glm::max(high, point);
    }
    middle_ = 0.5f * (low + high);
    radius_ = 0.0f;
    for (const glm::vec3& point : copies_[0].model.points) radius_ = std::max(radius_, glm::distance(point, middle_));
    if (!(radius_ > 0.0f)) throw Error("the model", "is a single point");
    camera_ = world.create_with(Transform{}, Compose{.background = paper});
}

void Figure::arrange(Canvas canvas) {
    World& world = app_.world();
    world.set_resource(canvas);
    const float aspect = static_cast<float>(canvas.width) / static_cast<float>(canvas.height);
    const int columns = aspect > 1.6f ? 4 : aspect > 0.6f ? 2 : 1, rows = 4 / columns;
    const float width = cell_width * static_cast<float>(columns), height = cell_height * static_cast<float>(rows);
    const float half_height = 0.5f * radius_ * std::max(height, width / aspect);
    world.add(camera_, Camera{.projection = Projection::orthographic,
                              .ymag = half_height,
                              .znear = 0.1f * radius_,
                              .zfar = 10.0f * radius_});
    world.get_mutable<Transform>(camera_).translation = {0.0f, 0.0f, 4.0f * radius_};
    places_.clear();
    for (int i = 0; i < 4; ++i) {
        const float x = static_cast<float>(i % columns) - 0.5f * static_cast<float>(columns - 1);
        const float y = 0.5f * static_cast<float>(rows - 1) - static_cast<float>(i / columns);
        const glm::vec3 cell = radius_ * glm::vec3(x * cell_width, y * cell_height, 0.0f);
        places_.push_back(cell + radius_ * glm::vec3(0.0f, part_place, 0.0f));
        const Copy& copy = copies_[static_cast<std::size_t>(i)];
        const float letter = std::min(letter_height, 0.9f * cell_width / copy.label_width);
        world.get_mutable<Transform>(copy.label) = {.translation = cell + radius_ * glm::vec3(0.0f, label_place, 1.5f),
                                                    .scale = glm::vec3(letter * radius_)};
    }
    turn(0.0f, 0.0f);
}

void Figure::turn(float yaw, float pitch) {
    rotation_ =
        glm::normalize(glm::angleAxis(yaw, glm::vec3(0, 1, 0)) * glm::angleAxis(pitch, glm::vec3(1, 0, 0)) * rotation_);
    for (std::size_t i = 0; i < copies_.size(); ++i)
        app_.world().get_mutable<Transform>(copies_[i].model.root) = {.translation = places_[i] - rotation_ * middle_,
                                                                      .rotation = rotation_};
}
