// Real characters on the GPU against the CPU.

#include <hachure/components/animation.h>
#include <hachure/components/deform.h>
#include <hachure/components/deformed.h>
#include <hachure/runtime/assets/read_model.h>
#include <hachure/systems/model/spawn_model.h>
#include <hachure/tests/support/drawn_scene.h>
#include <hachure/tests/support/given_models.h>
#include <hachure/tests/support/gl_fixture.h>
#include <hachure/tests/systems/deform/gpu_shape.h>

#include <gtest/gtest.h>

#include <memory>
#include <string>

namespace hachure::test {
namespace {

using geometry::SkinMethod;

/// One model twice, deformed on the CPU and on the GPU, in several poses and by both methods.
struct GpuCharacterTest : GivenModelTest {
    void SetUp() override {
        GivenModelTest::SetUp();
        if (IsSkipped()) return;
        std::string reason;
        gpu::Context* context = GlContexts::use(gpu::Backend::egl, reason);
        if (!context) GTEST_SKIP() << "no EGL context: " << reason;
        scene = std::make_unique<DrawnScene>(*context, Canvas{64, 48});
    }

    SpawnedModel spawn(const assets::Model& model, DeformDevice device, SkinMethod method) {
        World& world = scene->world();
        SpawnedModel spawned = spawn_model(world, model);
        if (!spawned.clips.empty()) world.add(spawned.root, Animation{.clip = spawned.clips[0]});
        for (const Entity surface : spawned.surfaces) world.add(surface, Deform{.method = method, .device = device});
        return spawned;
    }

    std::unique_ptr<DrawnScene> scene;
};

TEST_P(GpuCharacterTest, AsOnTheCpu) {
    const assets::Model model = assets::read_model(file());
    for (const SkinMethod method : {SkinMethod::linear, SkinMethod::dual_quaternion}) {
        World& world = scene->world();
        const SpawnedModel cpu = spawn(model, DeformDevice::cpu, method);
        const SpawnedModel gpu = spawn(model, DeformDevice::gpu, method);
        spawn_framing_camera(world, cpu.points, {64, 48});
        std::size_t compared = 0;
        for (int pose = 0; pose < 4; ++pose) {
            scene->renderer().render_frame(pose == 0 ? 0.0 : 0.23);
            for (std::size_t i = 0; i < cpu.surfaces.size(); ++i) {
                const Deformed* shape = world.find<Deformed>(cpu.surfaces[i]);
                if (!shape || !item_of(world, gpu.surfaces[i])) continue;
                expect_same(*shape, read_back(world, gpu.surfaces[i]), shape->positions.size() / 500);
                EXPECT_TRUE(inside(world.get<Deformed>(gpu.surfaces[i]).bounds, shape->positions));
                ++compared;
            }
        }
        EXPECT_GE(compared, 4u);
        world.destroy(cpu.root);
        world.destroy(gpu.root);
    }
}

INSTANTIATE_TEST_SUITE_P(Given, GpuCharacterTest,
                         testing::Values("characters/khronos/CesiumMan.glb", "characters/khronos/Fox.glb",
                                         "characters/khronos/RiggedFigure.glb",
                                         "characters/morph/AnimatedMorphCube.glb",
                                         "characters/morph/AnimatedMorphSphere.glb",
                                         "characters/morph/MorphPrimitivesTest.glb",
                                         "characters/morph/MorphStressTest.glb"),
                         given_model_name);

} // namespace
} // namespace hachure::test
