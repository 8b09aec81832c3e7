#include <algorithm>
#include <cmath>
#include <random>

#include "gooch_scene.h"

// Tones and highlights of several lights, of lights that end, and of those that move with the camera.
namespace hachure::test {
namespace {

constexpr double light_tolerance = 1e-3;

using GoochLightsTest = GlTest;

glm::quat shining(glm::vec3 from, glm::vec3 to) {
    return glm::quatLookAt(glm::normalize(to - from), glm::vec3(0.1f, 1.0f, 0.2f));
}

struct PlacedLight {
    Light light;
    Transform place;
};

/// Two suns, a lamp with an end, and a spot with a soft edge, none of them white and none alike.
std::vector<PlacedLight> four_lights() {
    return {{{.color = {1.0f, 0.9f, 0.8f}, .intensity = 3.0f}, {.rotation = shining({1, 3, 2}, {})}},
            {{.color = {0.2f, 0.5f, 1.0f}, .intensity = 2.0f}, {.rotation = shining({-3, 0.5f, 2}, {})}},
            {{.kind = LightKind::point, .color = {0.9f, 0.3f, 0.2f}, .intensity = 2.5f, .range = 3.5f},
             {.translation = {0.5f, -0.5f, 2.5f}}},
            {{.kind = LightKind::spot, .intensity = 1.0f, .inner_cone = 0.1f, .outer_cone = 0.5f},
             {.translation = {-2.0f, 4.0f, 3.0f}, .rotation = shining({-2, 4, 3}, {-1.2f, 0.8f, 1.2f})}}};
}

/// The same in double, relative to the strongest.
std::vector<CastLight> cast_lights(const std::vector<PlacedLight>& placed) {
    double strongest = 0.0;
    for (const auto& [light, place] : placed)
        strongest =
            std::max(strongest, double(light.intensity * std::max({light.color.r, light.color.g, light.color.b})));
    std::vector<CastLight> result;
    for (const auto& [light, place] : placed)
        result.push_back({.kind = light.kind,
                          .place = place.translation,
                          .towards = glm::dquat(place.rotation) * dvec3(0, 0, 1),
                          .color = dvec3(light.color) * double(light.intensity) / strongest,
                          .range = light.range,
                          .inner = light.inner_cone,
                          .outer = light.outer_cone});
    return result;
}

std::vector<Entity> add_lights(World& world, const std::vector<PlacedLight>& placed) {
    std::vector<Entity> result;
    for (const auto& [light, place] : placed) result.push_back(world.create_with(place, light));
    return result;
}

std::vector<Arriving> all_arriving(const std::vector<CastLight>& lights, const dvec3& point, const RayCamera& camera) {
    std::vector<Arriving> result;
    for (const CastLight& light : lights) result.push_back(arriving(light, point, camera));
    return result;
}

TEST_P(GoochLightsTest, SeveralLightsMatchTheClosedForm) {
    const std::vector<CastLight> lights = cast_lights(four_lights());
    for (const Camera& view : both_projections()) {
        GoochScene scene(context(), view);
        add_lights(scene.scene.world(), four_lights());
        Gooch tone{.shininess = 12.0f}, phong{.shading = GoochShading::phong, .shininess = 12.0f};
        scene.set(tone);
        const auto tones =
            scene.compare([&](const CastObject& object, const Hit& hit, const dvec3& point, const dvec3& to_eye) {
                return tone_color(tone, object.color, hit.normal, to_eye, all_arriving(lights, point, scene.camera));
            });
        scene.set(phong);
        const auto phongs =
            scene.compare([&](const CastObject& object, const Hit& hit, const dvec3& point, const dvec3& to_eye) {
                return phong_color(phong, object.color, hit.normal, to_eye, all_arriving(lights, point, scene.camera));
            });
        std::printf("four lights: tone %.2e, phong %.2e\n", tones.error, phongs.error);
        EXPECT_LE(tones.error, light_tolerance);
        EXPECT_LE(phongs.error, light_tolerance);
        EXPECT_GT(tones.drawn, 10'000);
        // Their approximation stays the tones' own without highlights.
        tone.highlight = 0.0f;
        scene.set(tone);
        const assets::Image exact = scene.draw();
        tone.shading = GoochShading::two_lights;
        scene.set(tone);
        EXPECT_LE(difference(scene.draw(), exact), 1e-6);
    }
}

TEST_P(GoochLightsTest, TheOrderOfLightsChangesNothingAndWhiteIsNotExceeded) {
    // Six of one strength, so that the list's order is that in which they were made.
    std::vector<PlacedLight> lights;
    for (int i = 0; i < 6; ++i)
        lights.push_back({{.color = {1.0f, 0.2f * static_cast<float>(i), 1.0f}},
                          {.rotation = shining({std::sin(float(i)), 1.0f, 1.5f + std::cos(float(i))}, {})}});
    std::vector<assets::Image> pictures;
    for (int turn = 0; turn < 3; ++turn) {
        GoochScene scene(context(), both_projections()[0]);
        scene.set({.y = 1.0f, .alpha = 0.0f, .beta = 0.0f, .highlight = 1.0f, .shininess = 3.0f});
        add_lights(scene.scene.world(), lights);
        pictures.push_back(scene.draw());
        std::shuffle(lights.begin(), lights.end(), std::mt19937(static_cast<unsigned>(turn)));
    }
    EXPECT_LE(difference(pictures[0], pictures[1]), 1e-5);
    EXPECT_LE(difference(pictures[0], pictures[2]), 1e-5);
    float brightest = 0.0f;
    for (int i = 0; i < 3 * GoochScene::canvas.width * GoochScene::canvas.height; ++i)
        brightest = std::max(brightest, pictures[0].f32()[i]);
    EXPECT_LE(brightest, 1.0f + 1e-6f);
}

TEST_P(GoochLightsTest, LightsThatReachNothingChangeNothing) {
    GoochScene scene(context(), both_projections()[0]);
    World& world = scene.scene.world();
    world.create_with(Transform{.rotation = shining({1, 2, 3}, {})}, Light{});
    const assets::Image alone = scene.draw();
    world.create_with(Transform{.rotation = shining({-3, 2, 1}, {})}, Light{.intensity = 0.0f});
    world.create_with(Transform{.translation = {0, 40, 0}}, Light{.kind = LightKind::point, .range = 5.0f});
    world.create_with(Transform{.translation = {0, 0, 9}, .rotation = shining({}, {0, 0, 1})},
                      Light{.kind = LightKind::spot});
    EXPECT_LE(difference(scene.draw(), alone), 1e-6);
    // More than a program is made for each number of.
    for (int i = 0; i < 3; ++i) world.create_with(Transform{}, Light{.intensity = 0.0f});
    EXPECT_LE(difference(scene.draw(), alone), 1e-6);
}

/// A light fades in, becomes the strongest and stays alone: no step changes a colour by more than steps of this
/// size must, and the ends are the pictures of one light.
TEST_P(GoochLightsTest, LightsFadeWithoutAPop) {
    GoochScene scene(context(), both_projections()[0]);
    World& world = scene.scene.world();
    const Entity first =
        world.create_with(Transform{.rotation = shining({1, 2, 3}, {})}, Light{.color = {1, 0.9f, 0.8f}});
    const assets::Image start = scene.draw();
    const Entity second =
        world.create_with(Transform{.rotation = shining({-3, 2, 1}, {})}, Light{.color = {0.4f, 0.6f, 1.0f}});
    // Relative to the stronger, strengths move by .05 a step; a weight moves by less, a
    // tone by k_warm - k_cool = .8 of that, a highlight by all of it.
    assets::Image before = start;
    double worst = 0.0;
    for (int step = 0; step <= 40; ++step) {
        const float share = static_cast<float>(step) / 40.0f;
        world.get_mutable<Light>(first).intensity = std::min(1.0f, 2.0f - 2.0f * share);
        world.get_mutable<Light>(second).intensity = std::min(1.0f, 2.0f * share);
        const assets::Image now = scene.draw();
        worst = std::max(worst, difference(before, now));
        before = now;
    }
    std::printf("greatest step of 40: %.4f\n", worst);
    EXPECT_LE(worst, 0.09);
    EXPECT_GT(difference(start, before), 0.4);
    world.destroy(first);
    EXPECT_LE(difference(scene.draw(), before), 1e-6);
}

/// Tones alone: (1 + l.n)/2 in every channel.
Gooch weight_only() { return {.b = 0.0f, .y = 0.0f, .alpha = 0.0f, .beta = 1.0f, .highlight = 0.0f}; }

struct Span {
    double low = 1.0, high = -1.0;
};

/// l.n over what is drawn.
Span drawn_span(GoochScene& scene) {
    const assets::Image image = scene.draw();
    Span span;
    for (std::size_t i = 0; i < scene.hits.size(); ++i) {
        if (scene.hits[i].object == 0) continue;
        span.low = std::min(span.low, 2.0 * double(image.f32()[3 * i]) - 1.0);
        span.high = std::max(span.high, 2.0 * double(image.f32()[3 * i]) - 1.0);
    }
    return span;
}

Entity add_camera_light(World& world, LightRig rig) {
    const Entity light = spawn_default_light(world);
    world.get_mutable<Light>(light).rig = rig;
    return light;
}

/// A wide-angle camera and a sphere, in the middle or far from it, seen from several places.
struct Look {
    glm::vec3 sphere; ///< its centre; its radius is .75
    Camera camera;
    Transform place;
};

std::vector<Look> wide_looks() {
    std::vector<Look> looks;
    for (const float turn : {0.0f, 1.0f, 2.5f, 4.4f}) {
        const glm::quat rotation =
            glm::angleAxis(turn, glm::vec3(0, 1, 0)) * glm::angleAxis(0.7f * std::sin(3.0f * turn), glm::vec3(1, 0, 0));
        const Transform place{.translation = {2.0f * turn, 1.0f, -3.0f}, .rotation = rotation};
        for (const glm::vec3 at :
             {glm::vec3(0, 0, -2.6f), glm::vec3(1.4f, 0.9f, -2.4f), glm::vec3(-1.4f, -0.8f, -2.4f)}) {
            const glm::vec3 centre = place.translation + rotation * at;
            looks.push_back({centre, {.yfov = 1.4f}, place});
        }
    }
    return looks;
}

/// With rig `gaze`, l.n spans [-1, 1] over a sphere wherever it stands in the picture; what lacks is the last pixel
/// before the outline. The camera's axis alone leaves out up to a third far from the middle.
TEST_P(GoochLightsTest, GazeLightSpansAllTonesFromAnyCamera) {
    double camera_least = 1.0;
    for (const Look& look : wide_looks()) {
        const std::vector<CastObject> sphere = {
            {CastObject::sphere, {.translation = look.sphere, .scale = glm::vec3(0.75f)}, dvec3(1.0)}};
        GoochScene scene(context(), look.camera, sphere, look.place);
        World& world = scene.scene.world();
        scene.set(weight_only());
        const Entity light = add_camera_light(world, LightRig::gaze);
        const CastLight cast{.towards = scene.camera.light(), .gaze = true};
        const auto worst = scene.compare([&](const CastObject&, const Hit& hit, const dvec3& point, const dvec3&) {
            return dvec3(0.5 + 0.5 * glm::dot(arriving(cast, point, scene.camera).l, hit.normal));
        });
        EXPECT_LE(worst.error, light_tolerance);
        const Span gaze = drawn_span(scene);
        EXPECT_GT(gaze.high, 0.96);
        EXPECT_LT(gaze.low, -0.96);
        world.get_mutable<Light>(light).rig = LightRig::camera;
        const Span camera = drawn_span(scene);
        camera_least = std::min({camera_least, camera.high, -camera.low});
    }
    std::printf("camera rig: l.n reaches %.3f at least\n", camera_least);
    EXPECT_LT(camera_least, 0.85);
}

/// In an orthographic view both rigs are one, and span everything.
TEST_P(GoochLightsTest, CameraLightSpansAllTonesOfAnOrthographicView) {
    const Camera view{.projection = Projection::orthographic, .ymag = 1.3f, .zfar = 100.0f};
    for (const LightRig rig : {LightRig::camera, LightRig::gaze}) {
        const Transform place = tilted_camera();
        GoochScene scene(context(), view, {{CastObject::sphere, {}, dvec3(1.0)}}, place);
        scene.set(weight_only());
        add_camera_light(scene.scene.world(), rig);
        const Span span = drawn_span(scene);
        EXPECT_GT(span.high, 0.97);
        EXPECT_LT(span.low, -0.97);
    }
}

/// A light in the world stays: a camera that goes round the shapes sees each normal in one tone.
TEST_P(GoochLightsTest, WorldLightStaysWhileTheCameraMoves) {
    const dvec3 l = glm::normalize(dvec3(1, 2, 0.5));
    for (const float turn : {0.0f, 1.2f, 3.0f}) {
        const glm::quat rotation = glm::angleAxis(turn, glm::vec3(0, 1, 0)) * glm::angleAxis(-0.3f, glm::vec3(1, 0, 0));
        const Transform place{.translation = rotation * glm::vec3(0, 0, 7), .rotation = rotation};
        GoochScene scene(context(), both_projections()[0], three_shapes(), place);
        scene.set(weight_only());
        scene.scene.world().create_with(Transform{.rotation = shining(glm::vec3(l), {})}, Light{});
        const auto worst = scene.compare([&](const CastObject& object, const Hit& hit, const dvec3&, const dvec3&) {
            return (0.5 + 0.5 * glm::dot(l, hit.normal)) * object.color;
        });
        EXPECT_LE(worst.error, light_tolerance);
        EXPECT_GT(worst.drawn, 8'000);
    }
}

HACHURE_INSTANTIATE_GL_TESTS_ONCE(GoochLightsTest);

} // namespace
} // namespace hachure::test
