// Metal on surfaces that deform: stripes stay on the vertices, the light's stripe follows the shape.

#include <hachure/components/animation.h>
#include <hachure/components/deform.h>
#include <hachure/components/deformed.h>
#include <hachure/runtime/assets/read_model.h>
#include <hachure/systems/metal/stripe_layout.h>
#include <hachure/systems/model/spawn_model.h>
#include <hachure/tests/support/arm_model.h>
#include <hachure/tests/support/given_models.h>
#include <hachure/tests/support/gl_fixture.h>

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "metal_scene.h"

namespace hachure::test {
namespace {

constexpr Canvas deform_canvas{96, 72};

/// The first clip of a model, with metal of that source.
struct MovingMetal {
    DrawnScene scene;
    SpawnedModel model;

    MovingMetal(gpu::Context& context, const assets::Model& source, const Metal& metal)
        : scene(context, deform_canvas), model(spawn_model(scene.world(), source)) {
        World& world = scene.world();
        for (const Entity surface : model.surfaces) {
            world.add(surface, metal);
            world.add(surface, Deform{.device = DeformDevice::gpu}); // metal needs it on the CPU nevertheless
        }
        spawn_framing_camera(world, model.points, deform_canvas);
        spawn_default_light(world);
        if (!model.clips.empty()) world.add(model.root, Animation{.clip = model.clips[0]});
        scene.renderer().request_aov("color");
    }
    assets::Image draw(double seconds) {
        scene.renderer().render_frame(seconds);
        return scene.renderer().read_aov("color");
    }
    MetalFrame& frame() { return scene.world().resource_mutable<MetalFrame>(); }
};

void expect_carried(MovingMetal& moving) {
    static_cast<void>(moving.draw(0.0));
    const assets::Image first = moving.draw(0.0);
    const std::size_t layouts = moving.frame().surfaces.layout_count();
    std::uint64_t computed = moving.frame().surfaces.frames_computed();
    assets::Image last;
    for (int pose = 0; pose < 3; ++pose) {
        last = moving.draw(0.21);
        EXPECT_TRUE(all_finite(last));
        EXPECT_GT(moving.frame().surfaces.frames_computed(), computed); // the shape changed
        computed = moving.frame().surfaces.frames_computed();
    }
    EXPECT_GT(changed_share(first, last, 0.05), 0.005);
    EXPECT_EQ(moving.frame().surfaces.layout_count(), layouts); // the coordinate stays with the vertices
    for (const Entity surface : moving.model.surfaces)
        if (const Deformed* shape = moving.scene.world().find<Deformed>(surface)) {
            EXPECT_FALSE(shape->on_gpu);
        }
}

using MetalDeformTest = GlTest;

TEST_P(MetalDeformTest, StripesAreCarriedAlong) {
    for (const MetalSource source : {MetalSource::curvature, MetalSource::around_axis, MetalSource::along_axis}) {
        SCOPED_TRACE(static_cast<int>(source));
        MovingMetal moving(context(), arm_model(), {.source = source});
        expect_carried(moving);
    }
}

/// A round arm about Y, swollen to twice its width everywhere, is the same cylinder but for its size: each vertex keeps
/// its stripe, and the light's stripe is as far from it. By vertices, it looks as it does by the angle of each
/// fragment.
TEST_P(MetalDeformTest, AnglesOfVerticesAreThoseOfFragments) {
    const Metal metal{.source = MetalSource::around_axis, .sets = 2};
    const geometry::Shape shape = geometry::cylinder(1.0, 3.0, 512);
    MetalScene rigid(context(), deform_canvas, surface_mesh(shape), metal, {1, 0.4f, 1}, 2.0f,
                     {.rotation = glm::angleAxis(0.3f, glm::vec3(0, 0, 1))});
    MetalScene moved(context(), deform_canvas, surface_mesh(shape), metal, {1, 0.4f, 1}, 2.0f,
                     {.rotation = glm::angleAxis(0.3f, glm::vec3(0, 0, 1))});
    moved.scene.world().add(moved.object, Deformed{.positions = shape.positions,
                                                   .normals = shape.normals,
                                                   .bounds = geometry::bounds_of(shape.positions),
                                                   .version = 1});
    const assets::Image a = rigid.draw(), b = moved.draw();
    EXPECT_EQ(moved.frame().surfaces.frames_computed(), 1u);
    EXPECT_EQ(rigid.frame().surfaces.frames_computed(), 0u);
    EXPECT_LT(changed_share(a, b, 2.0 / 255.0), 0.002);
}

HACHURE_INSTANTIATE_GL_TESTS_ONCE(MetalDeformTest);

using MetalCharacterTest = GivenModelTest;

TEST_P(MetalCharacterTest, StripesAreCarriedAlong) {
    std::string reason;
    gpu::Context* context = GlContexts::use(gpu::Backend::egl, reason);
    if (!context) GTEST_SKIP() << "no EGL context: " << reason;
    MovingMetal moving(*context, assets::read_model(file()), {});
    expect_carried(moving);
}

INSTANTIATE_TEST_SUITE_P(Given, MetalCharacterTest,
                         ::testing::Values("characters/khronos/Fox.glb", "characters/khronos/CesiumMan.glb"),
                         given_model_name);

} // namespace
} // namespace hachure::test
