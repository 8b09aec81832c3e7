#include <hachure/components/name.h>
#include <hachure/components/world_transform.h>
#include <hachure/runtime/app/app.h>
#include <hachure/systems/camera/camera.h>

#include <glm/gtc/matrix_inverse.hpp>
#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace hachure {
namespace {

/// What an orthographic view without a far plane sees, in half heights of the view. Its depth is linear: in a 32-bit
/// float, this still tells a 16000th of the half height apart, which is finer than a pixel.
constexpr float unlimited_orthographic_depth = 1e3f;

/// Reversed depth (1 near, 0 far); a far plane of 0 is at infinity, or far away (orthographic).
glm::mat4 projection_matrix(const Camera& camera, float aspect) {
    const float n = camera.znear;
    const float f = camera.zfar > n ? camera.zfar : 0.0f;
    glm::mat4 p(0.0f);
    if (camera.projection == Projection::orthographic) {
        const float far_plane = f > 0.0f ? f : n + unlimited_orthographic_depth * camera.ymag;
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

constexpr float framing_margin = 1.08f; // room for lines and for the eye

struct FramingFit {
    glm::vec3 eye;       ///< in the camera's axes
    float nearest_depth; ///< of the points
};

/// The nearest eye that sees all points within the slopes. Per axis, the planes x = +-slope * depth that touch the
/// points meet where the eye has to be; the farther of the two axes decides.
FramingFit fit_points(std::span<const glm::vec3> points, const glm::quat& camera_from_world, float slope_x,
                      float slope_y) {
    const glm::vec2 slope(slope_x, slope_y);
    glm::vec2 high(std::numeric_limits<float>::lowest()), low(high);
    float nearest = std::numeric_limits<float>::lowest(), farthest = std::numeric_limits<float>::max();
    for (const glm::vec3& point : points) {
        const glm::vec3 p = camera_from_world * point;
        high = glm::max(high, glm::vec2(p) + slope * p.z);
        low = glm::max(low, slope * p.z - glm::vec2(p));
        nearest = std::max(nearest, p.z);
        farthest = std::min(farthest, p.z);
    }
    const glm::vec2 center = 0.5f * (high - low);
    const glm::vec2 depth = 0.5f * (high + low) / slope;
    const float size = std::max({depth.x - nearest, depth.y - nearest, nearest - farthest});
    const float least = nearest + std::max(0.05f * size, size > 0.0f ? 0.0f : 1.0f);
    const float z = std::max({depth.x, depth.y, least});
    return {{center, z}, z - nearest};
}

using Cameras = Query<const Camera, const WorldTransform>;

/// The active camera that was made first: queries promise no order, entity indices do.
Entity active_camera(const Cameras& cameras) {
    Entity chosen = Entity::null;
    for (auto [entity, camera, transform] : cameras)
        if (camera.active && (!chosen || entity < chosen)) chosen = entity;
    return chosen;
}

void update_view(Cameras cameras, const Canvas& canvas, View& view) {
    if (const auto active = cameras.find(active_camera(cameras))) {
        const auto& [entity, camera, transform] = *active;
        view = make_view(camera, transform.matrix, canvas);
        view.camera = entity;
    } else {
        view = make_view(Camera{}, glm::mat4(1.0f), canvas);
    }
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

Entity spawn_framing_camera(World& world, std::span<const glm::vec3> points, Canvas canvas) {
    Camera camera;
    const glm::quat turn =
        glm::angleAxis(0.45f, glm::vec3(0.0f, 1.0f, 0.0f)) * glm::angleAxis(-0.22f, glm::vec3(1.0f, 0.0f, 0.0f));
    const float slope_y = std::tan(0.5f * camera.yfov) / framing_margin;
    const float slope_x = slope_y * static_cast<float>(canvas.width) / static_cast<float>(canvas.height);
    const FramingFit fit = fit_points(points, glm::conjugate(turn), slope_x, slope_y);
    camera.znear = std::max(1e-20f, 0.5f * fit.nearest_depth);
    Transform transform;
    transform.rotation = turn;
    transform.translation = turn * fit.eye;
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
