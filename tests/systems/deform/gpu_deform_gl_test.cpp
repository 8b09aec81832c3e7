// Deformation on the GPU against that on the CPU: two surfaces of one mesh follow the same joints, one on each; their
// vertices are compared, read back from the buffer that is drawn.

#include <hachure/components/deform.h>
#include <hachure/components/deformed.h>
#include <hachure/components/morph_weights.h>
#include <hachure/components/skin.h>
#include <hachure/systems/deform/deform.h>
#include <hachure/tests/support/drawn_scene.h>
#include <hachure/tests/support/gl_fixture.h>
#include <hachure/tests/systems/deform/gpu_shape.h>
#include <hachure/tests/systems/deform/random_mesh.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <utility>

namespace hachure::test {
namespace {

using geometry::SkinMethod;

struct GpuDeformTest : GlTest {
    void SetUp() override {
        GlTest::SetUp();
        if (!IsSkipped()) start();
    }
    void start() {
        scene = std::make_unique<DrawnScene>(context(), Canvas{64, 48});
        scene->add(Camera{.projection = Projection::orthographic, .ymag = 20.0f}, {.translation = {0, 0, 100}});
    }
    void TearDown() override {
        scene.reset();
        GlTest::TearDown();
    }

    World& world() { return scene->world(); }

    /// The mesh on both devices; `poses` of joints whose rest pose is identity.
    void add_pair(SurfaceMesh mesh, const std::vector<Transform>& poses, std::vector<float> weights,
                  SkinMethod method) {
        MeshStore& store = world().resource_mutable<MeshStore>();
        const std::uint32_t index = store.add(std::move(mesh));
        const std::size_t count = store.mesh(index).skin.joint_count();
        const std::vector<glm::mat4> identities(count, glm::mat4(1.0f));
        Skin skin{.binding = store.add(SkinBinding{"skin", identities, identities}), .joints = {}};
        skin.joints.resize(count);
        for (std::size_t j = 0; j < poses.size(); ++j) skin.joints[j] = world().create_with(poses[j]);
        for (const DeformDevice device : {DeformDevice::cpu, DeformDevice::gpu}) {
            const Entity entity =
                world().create_with(Transform{}, Surface{index}, Deform{.method = method, .device = device});
            if (count > 0) world().add(entity, Skin(skin));
            if (!weights.empty()) world().add(entity, MorphWeights{weights});
            (device == DeformDevice::cpu ? on_cpu : on_gpu) = entity;
        }
    }

    void expect_pair_same(std::size_t apart = 0) {
        scene->renderer().render_frame();
        const Deformed &cpu = world().get<Deformed>(on_cpu), &gpu = world().get<Deformed>(on_gpu);
        ASSERT_FALSE(cpu.on_gpu);
        ASSERT_TRUE(gpu.on_gpu && gpu.positions.empty());
        EXPECT_EQ(world().resource<DeformCounts>().on_gpu, 1u);
        expect_same(cpu, read_back(world(), on_gpu), apart);
        EXPECT_TRUE(inside(gpu.bounds, cpu.positions));
    }

    std::vector<Transform> poses(std::uint32_t count) {
        std::vector<Transform> result;
        for (std::uint32_t j = 0; j < count; ++j) result.push_back(random_joint(random));
        return result;
    }

    Random random;
    std::unique_ptr<DrawnScene> scene;
    Entity on_cpu, on_gpu;
};

TEST_P(GpuDeformTest, SkinsAndMorphsAsTheCpuDoes) {
    struct Case {
        SkinMethod method;
        int influences, targets;
    };
    // Programs take long to compile: each value with each other is enough.
    for (const auto& [method, influences, targets] : {Case{SkinMethod::linear, 4, 0},
                                                      {SkinMethod::linear, 8, 6},
                                                      {SkinMethod::dual_quaternion, 4, 6},
                                                      {SkinMethod::dual_quaternion, 8, 0}}) {
        SCOPED_TRACE(testing::Message() << "method " << static_cast<int>(method) << ", " << influences
                                        << " influences, " << targets << " targets");
        start();
        const Kind kind{.influences = influences, .targets = targets};
        SurfaceMesh mesh = random_mesh(random, kind);
        EXPECT_EQ(mesh.skin.influences(), static_cast<std::size_t>(influences));
        std::vector<float> weights;
        for (int t = 0; t < targets; ++t) weights.push_back(t == 4 ? 0.0f : random.in(-1.0f, 1.0f));
        add_pair(std::move(mesh), poses(kind.joints), weights, method);
        expect_pair_same(5);
    }
}

TEST_P(GpuDeformTest, MirroredCharacters) {
    for (const SkinMethod method : {SkinMethod::linear, SkinMethod::dual_quaternion}) {
        start();
        std::vector<Transform> joints = poses(6);
        for (Transform& joint : joints) {
            joint.rotation = glm::angleAxis(0.2f, random.unit());
            joint.scale.x = -joint.scale.x;
        }
        add_pair(random_mesh(random, {.joints = 6}), joints, {}, method);
        expect_pair_same(5);
        const Vertices vertices = read_back(world(), on_gpu);
        const SurfaceMesh& mesh = world().resource<MeshStore>().mesh(0);
        for (std::size_t v = 0; v < vertices.tangents.size(); ++v)
            ASSERT_EQ(vertices.tangents[v].w, -mesh.tangents[v].w) << v;
    }
}

TEST_P(GpuDeformTest, MirroredJointsBesideOthers) {
    std::vector<Transform> joints = poses(8);
    for (std::size_t j = 0; j < 4; ++j) joints[j].scale.y = -joints[j].scale.y;
    add_pair(random_mesh(random, {.joints = 8, .one_joint = true}), joints, {}, SkinMethod::linear);
    expect_pair_same();
    start();
    add_pair(random_mesh(random, {.joints = 8}), joints, {}, SkinMethod::linear);
    expect_pair_same(25); // opposite determinants cancel for some
}

/// Flat, thin as a line, a point, next to nothing; and huge.
TEST_P(GpuDeformTest, CollapsedJoints) {
    const std::vector<Transform> joints = {{.scale = {1, 0, 1}},
                                           {.translation = {0.5f, 0, 0}, .scale = {0, 0, 1}},
                                           {.translation = {0, 0.5f, 0}, .scale = {0, 0, 0}},
                                           {.translation = {0, 0, 0.5f}, .scale = {1e-12f, 1e-12f, 2e-12f}},
                                           {.scale = {1e8f, 1e8f, 2e8f}}};
    const Kind kind{.vertices = 300, .joints = 4, .one_joint = true};
    for (const SkinMethod method : {SkinMethod::linear, SkinMethod::dual_quaternion}) {
        start();
        add_pair(random_mesh(random, kind), {joints.begin(), joints.end() - 1}, {}, method);
        expect_pair_same();
        start();
        add_pair(random_mesh(random, {.vertices = 10, .joints = 1}), {joints.end() - 1, joints.end()}, {}, method);
        world().get_mutable<Camera>(world().query<const Camera>().first()).ymag = 1e9f;
        expect_pair_same();
    }
}

TEST_P(GpuDeformTest, VerticesWithoutWeightsStayAtRest) {
    const Kind kind{.influences = 8, .unweighted = 3};
    SurfaceMesh mesh = random_mesh(random, kind);
    const std::vector<glm::vec3> rest = mesh.positions;
    add_pair(std::move(mesh), poses(kind.joints), {}, SkinMethod::dual_quaternion);
    expect_pair_same(5);
    const Vertices vertices = read_back(world(), on_gpu);
    for (std::size_t v = 0; v < rest.size(); v += 3)
        ASSERT_LT(glm::distance(vertices.positions[v], rest[v]), 1e-6f) << v;
}

TEST_P(GpuDeformTest, AnyNumberOfJoints) {
    for (const auto& [joints, bytes] : {std::pair(255u, 1u), std::pair(700u, 2u), std::pair(70000u, 4u)}) {
        start();
        const Kind kind{.vertices = 2000, .joints = joints};
        SurfaceMesh mesh = random_mesh(random, kind);
        EXPECT_EQ(mesh.skin.joint_bytes(), bytes);
        // The others are none of the scene, and stand at rest.
        add_pair(std::move(mesh), poses(std::min(joints, 700u)), {}, SkinMethod::linear);
        expect_pair_same(20);
    }
}

TEST_P(GpuDeformTest, MorphsWithoutSkin) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    for (const std::vector<float>& weights : {std::vector{0.5f, -1.0f, 0.25f}, {0, 0, 0}, {nan, 0.5f, 0.0f}}) {
        start();
        add_pair(random_mesh(random, {.joints = 0, .targets = 3}), {}, weights, SkinMethod::linear);
        expect_pair_same();
    }
}

/// All of them, so that the base's is taken, or all but a little that points elsewhere.
TEST_P(GpuDeformTest, ATargetThatCancelsNormals) {
    SurfaceMesh mesh = random_mesh(random, {.vertices = 200, .joints = 0});
    std::vector<glm::vec3> positions(200, glm::vec3(0.1f)), normals, tangents;
    for (std::size_t v = 0; v < 200; ++v) {
        const glm::vec3 left = v % 2 ? glm::vec3(0.0f) : 0.01f * random.unit();
        normals.push_back(left - mesh.normals[v]);
        tangents.push_back(left - glm::vec3(mesh.tangents[v]));
    }
    const geometry::MorphDeltas deltas{positions, normals, tangents};
    mesh.morphs = {200, std::span(&deltas, 1)};
    add_pair(std::move(mesh), {}, {1.0f}, SkinMethod::linear);
    expect_pair_same();
}

TEST_P(GpuDeformTest, BoundsHoldWhatIsMorphedAndSkinned) {
    for (int round = 0; round < 20; ++round) {
        start();
        const Kind kind{.vertices = 40, .joints = 3, .targets = 2};
        std::vector<Transform> joints = poses(3);
        for (Transform& joint : joints) joint.rotation = glm::angleAxis(random.in(-3.1f, 3.1f), random.unit());
        add_pair(random_mesh(random, kind), joints, {random.in(-3.0f, 3.0f), random.in(-3.0f, 3.0f)},
                 round % 2 ? SkinMethod::linear : SkinMethod::dual_quaternion);
        scene->renderer().render_frame();
        EXPECT_TRUE(inside(world().get<Deformed>(on_gpu).bounds, world().get<Deformed>(on_cpu).positions)) << round;
    }
}

HACHURE_INSTANTIATE_GL_TESTS(GpuDeformTest);

} // namespace
} // namespace hachure::test
