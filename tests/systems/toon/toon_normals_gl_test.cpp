#include <hachure/components/deform.h>
#include <hachure/components/deformed.h>
#include <hachure/components/rig.h>
#include <hachure/components/toon.h>
#include <hachure/runtime/geometry/carry_normals.h>
#include <hachure/runtime/scene/draw_list.h>
#include <hachure/systems/deform/deform.h>
#include <hachure/systems/model/spawn_model.h>
#include <hachure/systems/toon/toon.h>
#include <hachure/tests/support/arm_model.h>
#include <hachure/tests/support/drawn_scene.h>
#include <hachure/tests/support/gl_fixture.h>

#include <glm/gtc/quaternion.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <random>

namespace hachure::test {
namespace {

struct ToonNormals : ::testing::Test {
    ToonNormals() {
        register_transform(app);
        register_deform(app);
        world().set_resource(DrawList{});
        world().set_resource(DrawClaims{});
        register_toon(app);
    }
    World& world() { return app.world(); }
    App app;
};

TEST_F(ToonNormals, AreMadeForThoseThatAskAndSharedByCopies) {
    const std::uint32_t mesh = world().resource_mutable<MeshStore>().add(surface_mesh(geometry::icosphere(1.0, 2)));
    const Entity plain = world().create_with(Transform{}, Surface{mesh}, Toon{});
    const Entity first = world().create_with(Transform{}, Surface{mesh}, Toon{.abstraction = 0.5f});
    const Entity second = world().create_with(Transform{}, Surface{mesh}, Toon{.abstraction = 1.0f});
    app.run_frame();
    EXPECT_FALSE(world().has<AbstractedNormals>(plain));
    ASSERT_TRUE(world().has<AbstractedNormals>(first));
    EXPECT_EQ(world().get<AbstractedNormals>(first).normals, world().get<AbstractedNormals>(second).normals);
    world().get_mutable<Toon>(second).abstracted_shape = AbstractedShape::cylinder;
    world().get_mutable<Toon>(first).abstraction = 0.0f;
    app.run_frame();
    EXPECT_FALSE(world().has<AbstractedNormals>(first)) << "nobody asks any more";
    ASSERT_TRUE(world().has<AbstractedNormals>(second));
    EXPECT_EQ(world().get<AbstractedNormals>(second).normals->size(), 162u);
    world().remove<Toon>(second);
    app.run_frame();
    EXPECT_FALSE(world().has<AbstractedNormals>(second));
}

/// What the job makes of the surface's own normals is what the skin makes of them.
TEST_F(ToonNormals, AreCarriedAsTheSurfaceIs) {
    for (const geometry::SkinMethod method : {geometry::SkinMethod::linear, geometry::SkinMethod::dual_quaternion}) {
        const SpawnedModel arm = spawn_model(world(), arm_model());
        const Entity surface = arm.surfaces[0];
        world().add(surface, Deform{.method = method});
        world().add(surface, Toon{.abstraction = 1.0f});
        const Entity elbow = world().get<Rig>(arm.root).nodes[2];
        world().get_mutable<Transform>(elbow).rotation = glm::angleAxis(1.2f, glm::vec3(0, 0, 1));
        app.run_frame();
        const Deformed& shape = world().get<Deformed>(surface);
        const SurfaceMesh& mesh = world().resource<MeshStore>().mesh(world().get<Surface>(surface).mesh);
        std::vector<glm::vec3> carried(mesh.normals.size());
        geometry::CarryNormalsJob job{.method = method,
                                      .rest = mesh.normals,
                                      .weights = &mesh.skin,
                                      .palette = shape.palette,
                                      .motions = shape.motions,
                                      .carried = carried};
        job.validate();
        job.run();
        double moved = 0.0;
        for (std::size_t i = 0; i < carried.size(); ++i) {
            EXPECT_LT(glm::distance(carried[i], shape.normals[i]), 1e-4f) << i;
            moved = std::max(moved, double(glm::distance(carried[i], mesh.normals[i])));
        }
        EXPECT_GT(moved, 1.0);
    }
}

/// The whole arm turned stiffly, and so did its abstracted normals.
TEST_F(ToonNormals, TurnWithTheModel) {
    const SpawnedModel arm = spawn_model(world(), arm_model());
    const Entity surface = arm.surfaces[0];
    for (const AbstractedShape shape :
         {AbstractedShape::smoothed, AbstractedShape::ellipsoid, AbstractedShape::sphere, AbstractedShape::cylinder}) {
        world().add(surface, Toon{.abstraction = 1.0f, .abstracted_shape = shape});
        app.run_frame();
        const std::vector<glm::vec3> before = *world().get<AbstractedNormals>(surface).normals;
        const std::uint64_t version = world().get<AbstractedNormals>(surface).version;
        const Entity shoulder = world().get<Rig>(arm.root).nodes[1];
        const glm::quat turn = glm::angleAxis(1.0f, glm::normalize(glm::vec3(1, 2, 3)));
        world().get_mutable<Transform>(shoulder).rotation = turn * world().get<Transform>(shoulder).rotation;
        app.run_frame();
        const AbstractedNormals& after = world().get<AbstractedNormals>(surface);
        EXPECT_NE(after.version, version);
        for (std::size_t i = 0; i < before.size(); ++i)
            EXPECT_LT(glm::distance(turn * before[i], (*after.normals)[i]), 1e-4f) << i;
        app.run_frame();
        EXPECT_EQ(world().get<AbstractedNormals>(surface).version, after.version) << "nothing moved";
    }
}

struct Picture {
    assets::Image color, normal;
};

/// A sphere whose normals are `rough` off their own, with that Toon.
Picture draw_rough(gpu::Context& context, const Toon& toon, float rough) {
    DrawnScene scene(context, {160, 120});
    for (const char* aov : {"color", "normal"}) scene.renderer().request_aov(aov);
    geometry::Shape ball = geometry::icosphere(1.0, 5);
    std::mt19937 random(3);
    std::normal_distribution<float> noise(0.0f, rough);
    if (rough > 0.0f)
        for (glm::vec3& n : ball.normals)
            n = glm::normalize(n + glm::vec3(noise(random), noise(random), noise(random)));
    scene.world().add(scene.add(surface_mesh(ball), {.scale = {1.2f, 0.7f, 1.0f}}), toon);
    scene.add(Camera{.yfov = 0.7f}, {.translation = {0.0f, 0.0f, 3.6f}});
    scene.renderer().render_frame();
    return {scene.renderer().read_aov("color"), scene.renderer().read_aov("normal")};
}

bool same_bits(const assets::Image& a, const assets::Image& b) {
    return a.pixels.size() == b.pixels.size() && std::memcmp(a.pixels.data(), b.pixels.data(), a.pixels.size()) == 0;
}

double mean_difference(const assets::Image& a, const assets::Image& b) {
    double sum = 0.0;
    const int count = a.width * a.height * a.channels;
    for (int i = 0; i < count; ++i) sum += std::abs(double(a.f32()[i]) - double(b.f32()[i]));
    return sum / count;
}

using AbstractionTest = GlTest;

TEST_P(AbstractionTest, NoneIsNone) {
    const Picture plain = draw_rough(context(), Toon{}, 0.3f);
    for (const AbstractedShape shape : {AbstractedShape::smoothed, AbstractedShape::sphere})
        EXPECT_TRUE(same_bits(draw_rough(context(), Toon{.abstraction = 0.0f, .abstracted_shape = shape}, 0.3f).color,
                              plain.color));
}

/// Whatever the surface's normals, the tones are those of the abstracted shape; the surface stays what it is.
TEST_P(AbstractionTest, TonesAreThoseOfTheAbstractedShape) {
    const Picture clean = draw_rough(context(), Toon{}, 0.0f), rough = draw_rough(context(), Toon{}, 0.3f);
    EXPECT_GT(mean_difference(rough.color, clean.color), 0.01);
    for (const AbstractedShape shape :
         {AbstractedShape::sphere, AbstractedShape::ellipsoid, AbstractedShape::smoothed}) {
        const Toon toon{.abstraction = 1.0f, .abstracted_shape = shape, .abstraction_radius = 0.2f};
        const Picture found = draw_rough(context(), toon, 0.3f);
        EXPECT_LT(mean_difference(found.color, clean.color),
                  (shape == AbstractedShape::smoothed ? 0.3 : 0.02) * mean_difference(rough.color, clean.color))
            << int(shape);
        EXPECT_TRUE(same_bits(found.normal, rough.normal)) << "the AOV shows the surface's own normals";
    }
}

TEST_P(AbstractionTest, FollowsACharacterAndStaysFinite) {
    DrawnScene scene(context(), {96, 96});
    scene.renderer().request_aov("color");
    const SpawnedModel arm = spawn_model(scene.world(), arm_model());
    for (const Entity surface : arm.surfaces) {
        scene.world().add(surface, Toon{.specular = 0.5f, .abstraction = 0.7f});
        scene.world().add(surface, Deform{.device = DeformDevice::gpu}); // a wish that abstraction does not grant
    }
    scene.add(Camera{.yfov = 0.7f}, {.translation = {0.0f, 1.0f, 5.0f}});
    const Entity elbow = scene.world().get<Rig>(arm.root).nodes[2];
    assets::Image last;
    for (int frame = 0; frame < 4; ++frame) {
        scene.world().get_mutable<Transform>(elbow).rotation =
            glm::angleAxis(0.5f * static_cast<float>(frame), glm::vec3(0, 0, 1));
        scene.renderer().render_frame();
        const assets::Image color = scene.renderer().read_aov("color");
        for (int i = 0; i < color.width * color.height * 3; ++i) ASSERT_TRUE(std::isfinite(color.f32()[i]));
        EXPECT_FALSE(frame > 0 && same_bits(color, last));
        last = color;
    }
    EXPECT_EQ(scene.draw_passes().at("toon"), gpu::PassState::reused);
}

HACHURE_INSTANTIATE_GL_TESTS(AbstractionTest);

} // namespace
} // namespace hachure::test
