// Deformation on the GPU against that on the CPU: two surfaces of one mesh follow the same joints, one on each; their
// vertices are compared, read back from the buffer that is drawn.

#include <hachure/components/animation.h>
#include <hachure/components/deform.h>
#include <hachure/components/deformed.h>
#include <hachure/components/edge_lines.h>
#include <hachure/components/gooch.h>
#include <hachure/components/morph_weights.h>
#include <hachure/components/rig.h>
#include <hachure/components/skin.h>
#include <hachure/runtime/assets/read_model.h>
#include <hachure/runtime/scene/render_context.h>
#include <hachure/systems/animation/animation.h>
#include <hachure/systems/deform/deform.h>
#include <hachure/systems/model/spawn_model.h>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <random>
#include <utility>

#include "../../support/arm_model.h"
#include "../../support/drawn_scene.h"
#include "../../support/given_models.h"
#include "../../support/gl_fixture.h"
#include "../../support/picture_compare.h"

namespace hachure::test {
namespace {

using geometry::SkinMethod;

class Random {
public:
    float in(float low, float high) { return low + (high - low) * static_cast<float>(bits_()) / 4294967296.0f; }
    std::uint32_t below(std::uint32_t count) { return static_cast<std::uint32_t>(bits_()) % count; }
    glm::vec3 vector(float most) { return {in(-most, most), in(-most, most), in(-most, most)}; }
    glm::vec3 unit() {
        for (;;) {
            const glm::vec3 v = vector(1.0f);
            if (glm::length(v) > 0.1f) return glm::normalize(v);
        }
    }

private:
    std::mt19937 bits_{20260917};
};

/// What a random mesh is to be like.
struct Kind {
    std::uint32_t vertices = 500;
    std::uint32_t joints = 20;
    int influences = 4;
    int targets = 0;        ///< dense and sparse ones in turn
    int unweighted = 0;     ///< every so manyth vertex follows no joint
    bool one_joint = false; ///< each vertex follows one only
};

geometry::SkinWeights random_weights(Random& random, const Kind& kind) {
    std::vector<glm::uvec4> joints[2];
    std::vector<glm::vec4> weights[2];
    for (std::uint32_t v = 0; v < kind.vertices; ++v)
        for (int set = 0; set < kind.influences / 4; ++set) {
            const bool none = kind.unweighted > 0 && v % static_cast<std::uint32_t>(kind.unweighted) == 0;
            glm::uvec4 joint(0);
            glm::vec4 weight(0.0f);
            for (int k = 0; k < (kind.one_joint ? 1 : 4); ++k) {
                joint[k] = random.below(kind.joints);
                weight[k] = none ? 0.0f : random.in(0.05f, 1.0f);
            }
            joints[set].push_back(joint);
            weights[set].push_back(weight);
        }
    return geometry::pack_skin_weights(kind.vertices, kind.joints, joints[0], weights[0], joints[1], weights[1]);
}

geometry::MorphTargets random_targets(Random& random, const Kind& kind) {
    std::vector<std::vector<glm::vec3>> arrays;
    for (int i = 0; i < 3 * kind.targets; ++i) {
        std::vector<glm::vec3>& array = arrays.emplace_back(kind.vertices, glm::vec3(0.0f));
        for (glm::vec3& delta : array)
            if (i / 3 % 2 == 0 || random.below(10) == 0) delta = random.vector(0.3f);
    }
    std::vector<geometry::MorphDeltas> deltas;
    for (std::size_t t = 0; t < arrays.size(); t += 3)
        deltas.push_back({arrays[t], arrays[t + 1], t == 3 ? std::span<const glm::vec3>() : arrays[t + 2]});
    return {kind.vertices, deltas};
}

SurfaceMesh random_mesh(Random& random, const Kind& kind) {
    SurfaceMesh mesh;
    mesh.name = "random";
    for (std::uint32_t v = 0; v < kind.vertices; ++v) {
        const glm::vec3 normal = random.unit();
        mesh.positions.push_back(random.vector(1.0f));
        mesh.normals.push_back(normal);
        mesh.tangents.emplace_back(glm::normalize(glm::cross(normal, random.unit())), v % 2 ? 1.0f : -1.0f);
        if (v >= 2) mesh.indices.insert(mesh.indices.end(), {v - 2, v - 1, v});
    }
    mesh.submeshes = {{0, static_cast<std::uint32_t>(mesh.indices.size()), {}}};
    if (kind.joints > 0) mesh.skin = random_weights(random, kind);
    if (kind.targets > 0) mesh.morphs = random_targets(random, kind);
    return mesh;
}

Transform random_joint(Random& random) {
    return {.translation = random.vector(0.5f),
            .rotation = glm::angleAxis(random.in(-1.0f, 1.0f), random.unit()),
            .scale = {random.in(0.7f, 1.4f), random.in(0.7f, 1.4f), random.in(0.7f, 1.4f)}};
}

struct Vertices {
    std::vector<glm::vec3> positions, normals;
    std::vector<glm::vec4> tangents;
};

const DrawItem* item_of(World& world, Entity entity) {
    for (const DrawItem& item : world.resource<DrawList>().items)
        if (item.entity == entity) return &item;
    return nullptr;
}

/// From the buffer that the surface was last drawn from.
Vertices read_back(World& world, Entity entity) {
    Vertices result;
    const DrawItem* item = item_of(world, entity);
    EXPECT_TRUE(item != nullptr && item->shape.on_gpu);
    if (!item || !item->shape.on_gpu) return result;
    GpuMeshes& meshes = world.resource_mutable<RenderContext>().meshes;
    EXPECT_TRUE(meshes.has_shape(*item));
    const MeshStore& store = world.resource<MeshStore>();
    const std::size_t count = store.mesh(item->mesh).positions.size();
    const gpu::Buffer& buffer = meshes.shape_buffer(store, *item);
    result.positions.resize(count);
    result.normals.resize(count);
    result.tangents.resize(store.mesh(item->mesh).tangents.size());
    buffer.read(std::span(result.positions));
    buffer.read(std::span(result.normals), count * sizeof(glm::vec3));
    if (!result.tangents.empty()) buffer.read(std::span(result.tangents), 2 * count * sizeof(glm::vec3));
    return result;
}

/// To 1e-4 of the shape's size, and of a unit vector; `apart` of the normals and tangents may be further apart (where
/// a blend of joints leaves next to nothing of a direction, rounding decides on it).
void expect_same(const Deformed& cpu, const Vertices& gpu, std::size_t apart = 0) {
    ASSERT_EQ(gpu.positions.size(), cpu.positions.size());
    ASSERT_EQ(gpu.tangents.size(), cpu.tangents.size());
    const float size = std::max(1e-6f, glm::length(cpu.bounds.extent()));
    std::size_t normals_apart = 0, tangents_apart = 0;
    for (std::size_t v = 0; v < cpu.positions.size(); ++v) {
        ASSERT_LT(glm::distance(gpu.positions[v], cpu.positions[v]), 1e-4f * size) << "vertex " << v;
        ASSERT_NEAR(glm::length(gpu.normals[v]), 1.0f, 1e-5f) << "vertex " << v;
        normals_apart += !(glm::distance(gpu.normals[v], cpu.normals[v]) < 1e-4f);
        if (cpu.tangents.empty()) continue;
        ASSERT_NEAR(glm::length(glm::vec3(gpu.tangents[v])), 1.0f, 1e-5f) << "vertex " << v;
        tangents_apart += !(glm::distance(gpu.tangents[v], cpu.tangents[v]) < 1e-4f);
    }
    EXPECT_LE(normals_apart, apart);
    EXPECT_LE(tangents_apart, apart);
}

bool inside(const geometry::Bounds& bounds, const std::vector<glm::vec3>& points) {
    const geometry::Bounds around = geometry::bounds_of(points);
    return glm::all(glm::lessThanEqual(bounds.low, around.low)) &&
           glm::all(glm::greaterThanEqual(bounds.high, around.high));
}

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

/// The arm, with a camera that sees it.
struct GpuArmTest : GlTest {
    void SetUp() override {
        GlTest::SetUp();
        if (IsSkipped()) return;
        scene = std::make_unique<DrawnScene>(context(), Canvas{160, 120});
        arm = spawn_model(world(), arm_model());
        spawn_framing_camera(world(), arm.points, {160, 120});
        spawn_default_light(world());
        world().add(surface(), Gooch{});
        world().add(surface(), Deform{.device = DeformDevice::gpu});
    }
    void TearDown() override {
        scene.reset();
        GlTest::TearDown();
    }

    World& world() { return scene->world(); }
    Entity surface() { return arm.surfaces[0]; }
    bool on_gpu() { return world().get<Deformed>(surface()).on_gpu; }
    void bend(float degrees) {
        world().get_mutable<Transform>(world().get<Rig>(arm.root).nodes[2]).rotation =
            glm::angleAxis(glm::radians(degrees), glm::vec3(0, 0, 1));
    }
    /// Without what is not there.
    std::optional<gpu::PassState> draw_pass() {
        const auto states = scene->draw_passes();
        const auto found = states.find("deform");
        return found == states.end() ? std::nullopt : std::optional(found->second);
    }

    std::unique_ptr<DrawnScene> scene;
    SpawnedModel arm;
};

TEST_P(GpuArmTest, PicturesAreTheSame) {
    bend(70.0f);
    world().get_mutable<MorphWeights>(surface()).values = {0.7f};
    const assets::Image gpu = scene->draw();
    ASSERT_TRUE(on_gpu());
    world().get_mutable<Deform>(surface()).device = DeformDevice::cpu;
    const assets::Image cpu = scene->draw();
    ASSERT_FALSE(on_gpu());
    EXPECT_TRUE(same_driver_gate(gpu, cpu));
    bend(0.0f);
    EXPECT_FALSE(same_driver_gate(gpu, scene->draw())) << "the pose is seen";
}

TEST_P(GpuArmTest, RunsWhenSomethingMoved) {
    bend(20.0f);
    EXPECT_EQ(draw_pass(), gpu::PassState::run);
    EXPECT_EQ(draw_pass(), gpu::PassState::reused);
    EXPECT_EQ(world().resource<DeformCounts>().surfaces, 0u);
    bend(30.0f);
    EXPECT_EQ(draw_pass(), gpu::PassState::run);
    world().get_mutable<Transform>(arm.root).translation.x = 0.1f;
    EXPECT_EQ(draw_pass(), gpu::PassState::reused) << "the shape is the same";
    world().get_mutable<MorphWeights>(surface()).values = {0.5f};
    EXPECT_EQ(draw_pass(), gpu::PassState::run);
    world().get_mutable<Deform>(surface()).method = SkinMethod::dual_quaternion;
    EXPECT_EQ(draw_pass(), gpu::PassState::run);
    world().get_mutable<Deform>(surface()).device = DeformDevice::cpu;
    EXPECT_EQ(draw_pass(), std::nullopt);
}

TEST_P(GpuArmTest, WhatComesBackIntoViewHasItsShape) {
    bend(50.0f);
    const assets::Image before = scene->draw();
    world().get_mutable<Surface>(surface()).visible = false;
    EXPECT_EQ(draw_pass(), std::nullopt);
    world().get_mutable<Surface>(surface()).visible = true;
    EXPECT_EQ(draw_pass(), gpu::PassState::run);
    EXPECT_TRUE(same_driver_gate(before, scene->renderer().read_picture()));
}

TEST_P(GpuArmTest, CopiesHaveShapesOfTheirOwn) {
    bend(20.0f);
    scene->draw();
    const Entity copy = world().get<Rig>(world().instantiate(arm.root)).morphs[0];
    bend(60.0f);
    scene->draw();
    const Vertices first = read_back(world(), surface()), second = read_back(world(), copy);
    EXPECT_GT(glm::distance(first.positions.back(), second.positions.back()), 0.3f);
}

TEST_P(GpuArmTest, StaysOnTheCpuForThoseWhoLookAtPositions) {
    bend(20.0f);
    scene->draw();
    EXPECT_TRUE(on_gpu());
    world().add(surface(), EdgeLines{});
    scene->draw();
    EXPECT_FALSE(on_gpu());
    EXPECT_EQ(world().get<Deformed>(surface()).positions.size(), 84u);
    world().remove<EdgeLines>(surface());
    scene->draw();
    EXPECT_TRUE(on_gpu());
    world().get_mutable<Deform>(surface()).normals = DeformedNormals::recomputed;
    scene->draw();
    EXPECT_FALSE(on_gpu());
    world().get_mutable<Deform>(surface()).normals = DeformedNormals::blended;
    scene->draw();
    EXPECT_TRUE(on_gpu());
    scene->renderer().request_aov("velocity");
    scene->draw();
    EXPECT_FALSE(on_gpu());
}

/// After its shape was left to the GPU.
TEST_P(GpuArmTest, LinesCanComeInTheMiddleOfAFrame) {
    bend(20.0f);
    scene->draw();
    scene->app().add_system(Stage::light, "late lines", [entity = surface(), done = false](Commands& commands) mutable {
        if (!std::exchange(done, true)) commands.add(entity, EdgeLines{});
    });
    bend(30.0f);
    scene->draw();
    EXPECT_TRUE(on_gpu());
    scene->draw();
    EXPECT_FALSE(on_gpu());
    EXPECT_EQ(world().get<Deformed>(surface()).positions.size(), 84u);
}

TEST(DeformDeviceTest, WithoutAGpuTheCpuDoes) {
    App app;
    register_transform(app);
    register_animation(app);
    register_deform(app);
    const SpawnedModel arm = spawn_model(app.world(), arm_model());
    app.world().add(arm.surfaces[0], Deform{.device = DeformDevice::gpu});
    app.run_frame();
    EXPECT_FALSE(app.world().get<Deformed>(arm.surfaces[0]).on_gpu);
    EXPECT_EQ(app.world().get<Deformed>(arm.surfaces[0]).positions.size(), 84u);
}

HACHURE_INSTANTIATE_GL_TESTS(GpuArmTest);

/// One model twice, deformed on the CPU and on the GPU, in several poses and by both methods.
struct GpuDeformModelTest : GivenModelTest {
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

TEST_P(GpuDeformModelTest, AsOnTheCpu) {
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

INSTANTIATE_TEST_SUITE_P(Given, GpuDeformModelTest,
                         testing::Values("characters/khronos/CesiumMan.glb", "characters/khronos/Fox.glb",
                                         "characters/khronos/RiggedFigure.glb",
                                         "characters/morph/AnimatedMorphCube.glb",
                                         "characters/morph/AnimatedMorphSphere.glb",
                                         "characters/morph/MorphPrimitivesTest.glb",
                                         "characters/morph/MorphStressTest.glb"),
                         given_model_name);

} // namespace
} // namespace hachure::test
