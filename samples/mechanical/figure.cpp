#include "figure.h"

#include <hachure/components/camera.h>
#include <hachure/components/compose.h>
#include <hachure/components/edge_lines.h>
#include <hachure/components/gooch.h>
#include <hachure/components/surface.h>
#include <hachure/components/transform.h>
#include <hachure/runtime/error.h>

#include <algorithm>
#include <utility>

#include "lettering.h"

using namespace hachure;

namespace {

constexpr glm::vec3 ink(0.03f, 0.03f, 0.04f), paper(1.0f);
constexpr glm::vec2 cell_size(2.0f, 2.4f), part_size(1.78f, 1.86f);                 ///< metres
constexpr float letter_height = 0.082f, part_height = 0.17f, label_height = -1.07f; ///< above the middle of a cell
constexpr float depth = 4.0f; ///< from the camera; models reach no farther than half of it towards either side

void add_lines(App& app, const SpawnedModel& model, float width) {
    for (const Entity surface : model.surfaces)
        app.world().add(surface, EdgeLines{.crease_angle = 0.5f, .width = width, .color = ink});
}

/// Other stripes for every piece.
void add_metal(App& app, const SpawnedModel& model, MetalSource source, float cool_to_warm) {
    Metal metal{.source = source, .seed = 0, .cool_to_warm = cool_to_warm};
    for (const Entity surface : model.surfaces) {
        ++metal.seed;
        app.world().add(surface, metal);
    }
}

} // namespace

glm::quat leaning() {
    return glm::angleAxis(0.34f, glm::vec3(0, 0, -1)) * glm::angleAxis(0.62f, glm::vec3(1, 0, 0)) *
           glm::angleAxis(0.2f, glm::vec3(0, 1, 0));
}

glm::quat half_profile() { return glm::angleAxis(0.2f, glm::vec3(1, 0, 0)) * glm::angleAxis(0.6f, glm::vec3(0, 1, 0)); }

std::vector<Cell> figure_10(const assets::Model& model, MetalSource stripes, glm::quat rotation) {
    const auto metal = [stripes](float cool_to_warm, bool lines) {
        return [=](App& app, const SpawnedModel& spawned, float width) {
            add_metal(app, spawned, stripes, cool_to_warm);
            if (lines) add_lines(app, spawned, width);
        };
    };
    const auto phong = [](App& app, const SpawnedModel& spawned, float) {
        for (const Entity surface : spawned.surfaces) app.world().add(surface, Gooch{.shading = GoochShading::phong});
    };
    return {{&model, "Phong", phong, rotation},
            {&model, "metal", metal(0.0f, false), rotation},
            {&model, "metal with edge lines", metal(0.0f, true), rotation},
            {&model, "metal, cool to warm", metal(1.0f, true), rotation}};
}

Figure::Figure(App& app, std::vector<Cell> cells, float line_width) : app_(app) {
    World& world = app.world();
    for (const Cell& cell : cells) {
        Copy copy{.model = spawn_model(world, *cell.model, stored_[cell.model]),
                  .label = world.create(),
                  .label_width = lettering_width(cell.label),
                  .rotation = cell.rotation};
        if (copy.model.points.empty()) throw Error("the model", "has nothing to draw");
        fit(copy, cell);
        cell.dress(app, copy.model, line_width);
        world.add(copy.label, Transform{});
        world.add(copy.label, Surface{world.resource_mutable<MeshStore>().add(lettering(cell.label, ink))});
        copies_.push_back(std::move(copy));
    }
    camera_ = world.create_with(Transform{.translation = {0.0f, 0.0f, depth}}, Compose{.background = paper});
}

/// As large as its cell allows, in the middle of what is seen of it.
void Figure::fit(Copy& copy, const Cell& cell) const {
    glm::vec3 low = copy.rotation * copy.model.points[0], high = low;
    for (const glm::vec3& point : copy.model.points) {
        low = glm::min(low, copy.rotation * point);
        high = glm::max(high, copy.rotation * point);
    }
    copy.pivot = glm::inverse(copy.rotation) * (0.5f * (low + high));
    const glm::vec3 size = high - low;
    if (std::max({size.x, size.y, size.z}) <= 0.0f) throw Error("the model", "is a single point");
    copy.scale = cell.zoom * std::min({part_size.x / std::max(size.x, 1e-9f * size.y),
                                       part_size.y / std::max(size.y, 1e-9f * size.x), depth / size.z});
}

void Figure::arrange(Canvas canvas) {
    World& world = app_.world();
    world.set_resource(canvas);
    const float aspect = static_cast<float>(canvas.width) / static_cast<float>(canvas.height);
    const int count = static_cast<int>(copies_.size());
    const int columns = aspect > (count > 8 ? 0.9f : count > 4 ? 1.2f : 1.6f) ? 4 : aspect > 0.6f ? 2 : 1;
    const int rows = (count + columns - 1) / columns;
    const glm::vec2 size = cell_size * glm::vec2(columns, rows);
    world.add(camera_, Camera{.projection = Projection::orthographic,
                              .ymag = 0.5f * std::max(size.y, size.x / aspect),
                              .znear = 0.1f * depth,
                              .zfar = 2.0f * depth});
    for (int i = 0; i < count; ++i) {
        Copy& copy = copies_[static_cast<std::size_t>(i)];
        const glm::vec2 at(static_cast<float>(i % columns) - 0.5f * static_cast<float>(columns - 1),
                           0.5f * static_cast<float>(rows - 1) - static_cast<float>(i / columns));
        const glm::vec3 cell(at * cell_size, 0.0f);
        copy.place = cell + glm::vec3(0.0f, part_height, 0.0f);
        const float letter = std::min(letter_height, 0.9f * cell_size.x / std::max(copy.label_width, 1.0f));
        world.get_mutable<Transform>(copy.label) = {.translation = cell + glm::vec3(0.0f, label_height, 0.5f * depth),
                                                    .scale = glm::vec3(letter)};
    }
    turn(0.0f, 0.0f);
}

void Figure::turn(float yaw, float pitch) {
    const glm::quat turned = glm::angleAxis(yaw, glm::vec3(0, 1, 0)) * glm::angleAxis(pitch, glm::vec3(1, 0, 0));
    for (Copy& copy : copies_) {
        copy.rotation = glm::normalize(turned * copy.rotation);
        app_.world().get_mutable<Transform>(copy.model.root) = {
            .translation = copy.place - copy.scale * (copy.rotation * copy.pivot),
            .rotation = copy.rotation,
            .scale = glm::vec3(copy.scale)};
    }
}
