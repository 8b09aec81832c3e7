#include <hachure/systems/camera/camera.h>

#include <hachure/components/name.h>
#include <hachure/components/world_transform.h>
#include <hachure/runtime/app/app.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_inverse.hpp>
#include <glm/gtc/quaternion.hpp>

namespace hachure {
namespace {

/// Reversed depth (1 near, 0 far); a far plane of 0 is at infinity.
glm::mat4 projection_matrix(const Camera& camera, float aspect) {
    const float n = camera.znear;
    const float f = camera.zfar > n ? camera.zfar : 0.0f;
    glm::mat4 p(0.0f);
    if (camera.projection == Projection::orthographic) {
        const float far_plane = f > 0.0f ? f : n + 1e6f * camera.ymag;
        p[0][0] = 1.0f / (camera.ymag * aspect);
        p[1][1] = 1.0f / camera.ymag;
        p[2][2] = 1.0f / (far_plane - n);
        p[3][2] = far_plane / (far_plane - n);
        p[3][3] = 1.0f;
        return p;
    }
    const float scale = 1.0f / std::tan(0.5f * camera.yfov);
    p[0][0] = scale / aspect;
    p[1][1] = scale;
    p[2][2] = f > 0.0f ? n / (f - n) : 0.0f;
    p[3][2] = f > 0.0f ? f * n / (f - n) : n;
    p[2][3] = -1.0f;
    return p;
}

glm::vec3 unit_or(glm::vec3 v, glm::vec3 fallback) {
    const float length = glm::length(v);
    return length > 0.0f && std::isfinite(length) ? v / length : fallback;
}

/// The active camera that was made first: queries promise no order, entity indices do.
Entity active_camera(World& world) {
    Entity chosen = Entity::null;
    for (auto [entity, camera, transform] : world.query<const Camera, const WorldTransform>())
        if (camera.active && (!chosen || entity < chosen)) chosen = entity;
    return chosen;
}

void update_view(World& world) {
    const Entity entity = active_camera(world);
    const Canvas canvas = world.resource<Canvas>();
    View view;
    if (entity) {
        view = make_view(world.get<Camera>(entity), world.get<WorldTransform>(entity).matrix, canvas);
        view.camera = entity;
    } else {
        view = make_view(Camera{}, glm::mat4(1.0f), canvas);
    }
    if (!(world.resource<View>() == view)) world.resource_mutable<View>() = view;
}

} // namespace

View make_view(const Camera& camera, const glm::mat4& world_from_camera, Canvas canvas) {
    View view;
    view.width = std::max(1, canvas.width);
    view.height = std::max(1, canvas.height);
    view.backward = unit_or(glm::vec3(world_from_camera[2]), {0.0f, 0.0f, 1.0f});
    view.right = unit_or(glm::cross(glm::vec3(world_from_camera[1]), view.backward), {1.0f, 0.0f, 0.0f});
    view.up = glm::cross(view.backward, view.right);
    const glm::vec3 place(world_from_camera[3]);
    const glm::mat4 pose(glm::vec4(view.right, 0.0f), glm::vec4(view.up, 0.0f), glm::vec4(view.backward, 0.0f),
                         glm::vec4(place, 1.0f));
    view.view_from_world = glm::affineInverse(pose);
    const float aspect = static_cast<float>(view.width) / static_cast<float>(view.height);
    view.clip_from_view = projection_matrix(camera, aspect);
    view.clip_from_world = view.clip_from_view * view.view_from_world;
    const bool perspective = camera.projection == Projection::perspective;
    view.eye = perspective ? glm::vec4(place, 1.0f) : glm::vec4(view.backward, 0.0f);
    const float height_metres = perspective ? 2.0f * std::tan(0.5f * camera.yfov) : 2.0f * camera.ymag;
    view.pixel_size = height_metres / static_cast<float>(view.height);
    return view;
}

Entity spawn_framing_camera(World& world, const geometry::Bounds& bounds, Canvas canvas) {
    Camera camera;
    const float radius = bounds.radius() > 0.0f ? bounds.radius() : 1.0f;
    const float aspect = static_cast<float>(canvas.width) / static_cast<float>(canvas.height);
    const float half_angle = std::atan(std::tan(0.5f * camera.yfov) * std::min(1.0f, aspect));
    const glm::quat turn = glm::angleAxis(0.45f, glm::vec3(0.0f, 1.0f, 0.0f)) *
                           glm::angleAxis(-0.22f, glm::vec3(1.0f, 0.0f, 0.0f));
    // The corners of the box, not the sphere around it, decide the distance, so that tall and flat things fill the view.
    const glm::quat inverse = glm::conjugate(turn);
    const float slope_y = std::tan(0.5f * camera.yfov), slope_x = slope_y * aspect;
    float distance = 0.0f;
    for (int i = 0; i < 8; ++i) {
        const glm::vec3 corner = inverse * (bounds.empty() ? glm::vec3(0.0f) : bounds.corner(i) - bounds.center());
        distance = std::max({distance, corner.z + std::abs(corner.x) / slope_x, corner.z + std::abs(corner.y) / slope_y});
    }
    if (!(distance > 0.0f)) distance = radius / std::sin(half_angle);
    distance *= 1.08f; // a margin for lines and for the eye
    camera.znear = std::max(1e-9f, std::max(distance - 1.5f * radius, 1e-3f * distance));
    Transform transform;
    transform.rotation = turn;
    transform.translation = bounds.center() + turn * glm::vec3(0.0f, 0.0f, distance);
    const Entity entity = world.create();
    world.add(entity, transform);
    world.add(entity, camera);
    world.add(entity, Name{"camera"});
    return entity;
}

void register_camera(App& app) {
    app.add_component<Camera>();
    if (!app.world().find_resource<Canvas>()) app.world().set_resource(Canvas{});
    app.world().set_resource(View{});
    app.add_system(Stage::light, "camera", update_view);
}

} // namespace hachure
