#pragma once

#include <hachure/components/gooch.h>
#include <hachure/components/light.h>
#include <hachure/tests/support/drawn_scene.h>
#include <hachure/tests/support/gl_fixture.h>

#include <glm/gtc/constants.hpp>

#include <functional>
#include <string>
#include <vector>

#include "closed_form.h"

/// Sphere, cylinder and torus in one picture, to be compared with closed forms.
namespace hachure::test {

/// Facets small enough for a thousandth: triangles span .0175 rad (sphere), .006 (cylinder), .012 and .025 (torus), so
/// that they lie at most .0175^2 / 6 = 5e-5 radii inside their surface. gooch_gl_test.cpp has the rest of the argument;
/// its finer sphere shows the same errors here.
inline const geometry::Shape& fine_shape(CastObject::Kind kind) {
    static const std::map<CastObject::Kind, geometry::Shape> shapes = {
        {CastObject::sphere, geometry::icosphere(1.0, 6)},
        {CastObject::cylinder, geometry::cylinder(1.0, 2.0, 1024)},
        {CastObject::torus, geometry::torus(1.0, torus_minor, 512, 256)}};
    return shapes.at(kind);
}

inline Transform tilted_camera() {
    const glm::quat turn = glm::angleAxis(0.6f, glm::vec3(0, 1, 0)) * glm::angleAxis(-0.4f, glm::vec3(1, 0, 0));
    return {.translation = turn * glm::vec3(0.1f, 0.1f, 7.0f), .rotation = turn};
}

/// Side by side as the camera of `tilted_camera` sees them, each turned another way.
inline std::vector<CastObject> three_shapes() {
    const glm::quat view = tilted_camera().rotation;
    const auto place = [&](glm::vec3 at, float angle, glm::vec3 axis, glm::vec3 scale) {
        return Transform{
            .translation = view * at, .rotation = view * glm::angleAxis(angle, glm::normalize(axis)), .scale = scale};
    };
    return {{CastObject::sphere, place({-1.9f, 0.9f, 0.0f}, 0.4f, {1, 2, 3}, glm::vec3(0.95f)), {0.8, 0.5, 0.3}},
            {CastObject::cylinder,
             place({1.9f, 0.8f, 0.2f}, 0.8f, {1, 0.3f, 0.5f}, {0.75f, 0.95f, 0.75f}),
             {0.3, 0.6, 0.8}},
            {CastObject::torus, place({-0.1f, -0.75f, 0.0f}, 0.9f, {1, 0.2f, 0.1f}, glm::vec3(1.1f)), {1.0, 1.0, 1.0}}};
}

inline const std::vector<Camera>& both_projections() {
    static const std::vector<Camera> cameras = {{.yfov = 0.65f},
                                                {.projection = Projection::orthographic, .ymag = 2.3f, .zfar = 100.0f}};
    return cameras;
}

/// The shapes, drawn as often as one likes with other fields and lights, and what each pixel sees of them.
class GoochScene {
public:
    static constexpr Canvas canvas{256, 192};
    /// The colour that a pixel must have, from what it sees.
    using Expected = std::function<dvec3(const CastObject&, const Hit&, const dvec3& point, const dvec3& to_eye)>;

    struct Worst {
        double error = 0.0;
        int checked = 0, drawn = 0;
    };

    GoochScene(gpu::Context& context, const Camera& view, const std::vector<CastObject>& shapes = three_shapes(),
               const Transform& place = tilted_camera())
        : objects(shapes), camera(view, place, canvas), hits(cast_all(objects, camera, canvas)),
          scene(context, canvas) {
        for (const CastObject& object : objects) {
            SurfaceMaterial material;
            material.base_color = glm::vec4(glm::vec3(object.color), 1.0f);
            entities.push_back(scene.add(surface_mesh(fine_shape(object.kind), material), object.transform));
            scene.world().add(entities.back(), Gooch{});
        }
        eye = scene.add(view, place);
        scene.renderer().request_aov("color");
    }

    void set(const Gooch& gooch) {
        for (const Entity entity : entities) scene.world().get_mutable<Gooch>(entity) = gooch;
    }

    /// Linear colours of a new frame, 3 floats a pixel, rows from the top.
    assets::Image draw() {
        scene.renderer().render_frame();
        return scene.renderer().read_aov("color");
    }

    Worst compare(const Expected& expected) {
        const assets::Image image = draw();
        Worst worst;
        for (int row = 0; row < canvas.height; ++row)
            for (int column = 0; column < canvas.width; ++column) {
                const int i = row * canvas.width + column;
                const Hit& hit = hits[static_cast<std::size_t>(i)];
                if (!away_from_outlines(hits, canvas, column, row)) continue;
                ++worst.checked;
                if (hit.object == 0) continue;
                ++worst.drawn;
                const Ray ray = camera.ray(column, row);
                const dvec3 point = ray.origin + hit.depth * ray.direction;
                const dvec3 color =
                    expected(objects[static_cast<std::size_t>(hit.object - 1)], hit, point, camera.to_eye(point));
                for (int c = 0; c < 3; ++c)
                    worst.error = std::max(worst.error, std::abs(double(image.f32()[3 * i + c]) - color[c]));
            }
        return worst;
    }

    std::vector<CastObject> objects;
    RayCamera camera;
    std::vector<Hit> hits;
    DrawnScene scene;
    std::vector<Entity> entities;
    Entity eye;
};

/// The parameters of the paper's figures 7 and 8.
inline Gooch figure_7() { return {.b = 0.4f, .y = 0.4f, .alpha = 0.2f, .beta = 0.6f, .highlight = 0.0f}; }
inline Gooch figure_8() { return {.b = 0.55f, .y = 0.3f, .alpha = 0.25f, .beta = 0.5f, .highlight = 0.0f}; }

/// The greatest difference of two pictures in any channel.
inline double difference(const assets::Image& a, const assets::Image& b) {
    double worst = 0.0;
    for (int i = 0; i < a.width * a.height * a.channels; ++i)
        worst = std::max(worst, std::abs(double(a.f32()[i]) - double(b.f32()[i])));
    return worst;
}

} // namespace hachure::test
