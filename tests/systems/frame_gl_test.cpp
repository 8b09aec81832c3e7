#include <hachure/components/compose.h>
#include <hachure/components/edge_lines.h>
#include <hachure/components/gooch.h>
#include <hachure/runtime/scene/draw_list.h>
#include <hachure/runtime/scene/render_context.h>
#include <hachure/tests/support/drawn_scene.h>
#include <hachure/tests/support/gl_fixture.h>
#include <hachure/tests/support/picture_compare.h>

#include <functional>
#include <set>

// What a frame does and leaves out, on the real passes.
namespace hachure::test {
namespace {

using gpu::PassState;
using Passes = std::map<std::string, PassState>;

constexpr Canvas canvas{128, 96};

/// A torus and a sphere in Gooch's tones with lines, drawn once.
struct Still {
    explicit Still(gpu::Context& context, bool lines = true) : scene(context, canvas) {
        torus = scene.add(surface_mesh(geometry::torus(1.0, 0.35, 48, 24)));
        sphere = scene.add(surface_mesh(geometry::icosphere(0.5, 3)), {.translation = {0.2f, 0.6f, 0.1f}});
        for (const Entity entity : {torus, sphere}) {
            scene.world().add(entity, Gooch{});
            if (lines) scene.world().add(entity, EdgeLines{});
        }
        const glm::quat turn = glm::angleAxis(-0.5f, glm::vec3(1, 0, 0));
        camera = scene.add(Camera{}, {.translation = turn * glm::vec3(0, 0, 6), .rotation = turn});
        light = spawn_default_light(scene.world());
        first = scene.draw_passes();
    }

    DrawnScene scene;
    Entity torus, sphere, camera, light;
    Passes first;
};

std::set<std::string> in_state(const Passes& passes, PassState state) {
    std::set<std::string> names;
    for (const auto& [name, pass_state] : passes)
        if (pass_state == state) names.insert(name);
    return names;
}

const std::set<std::string> none;

using FrameTest = GlTest;

TEST_P(FrameTest, HasThePassesThatItsEntitiesAskFor) {
    Still still(context());
    EXPECT_EQ(in_state(still.first, PassState::run),
              (std::set<std::string>{"targets", "gooch", "edge_lines", "overlay"}));
    EXPECT_EQ(still.first.size(), 4u);
}

TEST_P(FrameTest, NoLinesMeanNoLinePass) {
    Still still(context(), false);
    EXPECT_EQ(in_state(still.first, PassState::run), (std::set<std::string>{"targets", "gooch"}));
    EXPECT_EQ(still.first.size(), 2u);
}

TEST_P(FrameTest, LinesThatDrawNothingMeanNoLinePass) {
    Still still(context());
    for (const Entity entity : {still.torus, still.sphere})
        still.scene.world().get_mutable<EdgeLines>(entity).width = 0.0f;
    EXPECT_FALSE(still.scene.draw_passes().contains("edge_lines"));
}

TEST_P(FrameTest, ABufferThatNobodyAsksForIsNotMade) {
    Still still(context());
    EXPECT_FALSE(still.first.contains("depth"));
    EXPECT_FALSE(still.first.contains("encode"));
    still.scene.renderer().request_aov("depth");
    EXPECT_EQ(still.scene.draw_passes().at("depth"), PassState::run);
    EXPECT_EQ(still.scene.draw_passes().at("depth"), PassState::reused);
}

TEST_P(FrameTest, NothingChangedRunsNothing) {
    Still still(context());
    for (const char* aov : {"color", "normal", "depth", "object_id"}) still.scene.renderer().request_aov(aov);
    const assets::Image before = still.scene.draw();
    for (int frame = 0; frame < 3; ++frame) {
        const Passes passes = still.scene.draw_passes();
        EXPECT_EQ(in_state(passes, PassState::run), none);
        EXPECT_EQ(in_state(passes, PassState::reused).size(), passes.size());
    }
    EXPECT_EQ(still.scene.renderer().read_picture().pixels, before.pixels);
}

/// Clearing, tones and lines are written onto one texture in place, so that a new tone needs all three: of passes that
/// share a texture, all run or none does.
TEST_P(FrameTest, AChangedToneRunsTheChainOfTheColourOnce) {
    Still still(context());
    const assets::Image before = still.scene.draw();
    still.scene.world().get_mutable<Gooch>(still.torus).b = 0.9f;
    const Passes passes = still.scene.draw_passes();
    for (const char* pass : {"targets", "gooch", "overlay"}) EXPECT_EQ(passes.at(pass), PassState::run) << pass;
    EXPECT_NE(still.scene.renderer().read_picture().pixels, before.pixels);
    EXPECT_EQ(in_state(still.scene.draw_passes(), PassState::run), none);
    still.scene.world().get_mutable<Gooch>(still.torus).b = Gooch{}.b;
    EXPECT_EQ(still.scene.draw().pixels, before.pixels);
}

TEST_P(FrameTest, WritingTheSameTransformMovesNothing) {
    Still still(context());
    static_cast<void>(still.scene.world().get_mutable<Transform>(still.torus));
    EXPECT_EQ(in_state(still.scene.draw_passes(), PassState::run), none);
}

TEST_P(FrameTest, OnlySurfacesAndTheViewMakeTheDrawListAnew) {
    Still still(context());
    const auto key = [&] { return still.scene.world().resource<DrawList>().key; };
    const std::uint64_t first = key();
    still.scene.world().get_mutable<Transform>(still.light).rotation = {1, 0, 0, 0};
    EXPECT_EQ(in_state(still.scene.draw_passes(), PassState::run).count("gooch"), 1u) << "it is lit anew";
    EXPECT_EQ(key(), first) << "a light is no surface";
    std::set<std::uint64_t> keys{first};
    const auto expect_anew = [&](const char* what) {
        still.scene.draw();
        EXPECT_TRUE(keys.insert(key()).second) << what;
    };
    still.scene.world().get_mutable<Transform>(still.torus).translation.x = 0.1f;
    expect_anew("moved");
    still.scene.world().get_mutable<Surface>(still.torus).tint = {1, 0, 0};
    expect_anew("tinted");
    still.scene.world().remove<Surface>(still.sphere);
    expect_anew("without its surface");
    still.scene.world().destroy(still.torus);
    expect_anew("destroyed");
    still.scene.world().get_mutable<Camera>(still.camera).yfov = 0.9f;
    expect_anew("seen from another camera");
}

/// Whatever is changed, the picture is the one that a graph which kept nothing would draw.
TEST_P(FrameTest, ReuseNeverShowsWhatWas) {
    using Change = std::function<void(Still&)>;
    const auto world = [](Still& still) -> World& { return still.scene.world(); };
    const std::vector<std::pair<const char*, Change>> changes = {
        {"tone", [&](Still& s) { world(s).get_mutable<Gooch>(s.torus).y = 0.9f; }},
        {"highlight off", [&](Still& s) { world(s).get_mutable<Gooch>(s.sphere).highlight = 0.0f; }},
        {"width", [&](Still& s) { world(s).get_mutable<EdgeLines>(s.torus).width = 5.0f; }},
        {"line colour",
         [&](Still& s) {
             world(s).get_mutable<EdgeLines>(s.torus).color = {1, 0, 0};
         }},
        {"place", [&](Still& s) { world(s).get_mutable<Transform>(s.sphere).translation.x = -0.8f; }},
        {"camera", [&](Still& s) { world(s).get_mutable<Camera>(s.camera).yfov = 0.9f; }},
        {"light",
         [&](Still& s) {
             world(s).get_mutable<Transform>(s.light).rotation = {1, 0, 0, 0};
         }},
        {"tint",
         [&](Still& s) {
             world(s).get_mutable<Surface>(s.torus).tint = {0.5f, 1, 0};
         }},
        {"hidden", [&](Still& s) { world(s).get_mutable<Surface>(s.sphere).visible = false; }},
        {"shown again", [&](Still& s) { world(s).get_mutable<Surface>(s.sphere).visible = true; }},
        {"background",
         [&](Still& s) {
             world(s).add(s.camera, Compose{{0.2f, 0.3f, 0.4f}});
         }},
        {"one loses its tones", [&](Still& s) { world(s).remove<Gooch>(s.torus); }},
        {"the other loses its tones too", [&](Still& s) { world(s).remove<Gooch>(s.sphere); }},
        {"tones are back", [&](Still& s) { world(s).add(s.torus, Gooch{}); }},
        {"one loses its lines", [&](Still& s) { world(s).remove<EdgeLines>(s.torus); }},
        {"destroyed", [&](Still& s) { world(s).destroy(s.sphere); }},
        {"size",
         [&](Still& s) {
             world(s).set_resource(Canvas{96, 128});
         }},
    };
    Still still(context());
    assets::Image before = still.scene.draw();
    for (const auto& [name, change] : changes) {
        SCOPED_TRACE(name);
        change(still);
        const assets::Image after = still.scene.draw();
        EXPECT_TRUE(after.pixels != before.pixels) << "the change is not seen";
        world(still).resource_mutable<RenderContext>().graph.forget_results();
        EXPECT_TRUE(after.pixels == still.scene.draw().pixels) << "something stale is shown";
        before = after;
    }
}

TEST(FrameAcrossBackends, EglAndOsMesaDrawTheSamePicture) {
    std::string reason;
    gpu::Context* egl = GlContexts::use(gpu::Backend::egl, reason);
    if (!egl) GTEST_SKIP() << "no EGL context: " << reason;
    const assets::Image on_egl = Still(*egl).scene.draw();
    gpu::Context* osmesa = GlContexts::use(gpu::Backend::osmesa, reason);
    if (!osmesa) GTEST_SKIP() << "no OSMesa context: " << reason;
    EXPECT_TRUE(same_driver_gate(on_egl, Still(*osmesa).scene.draw()));
}

HACHURE_INSTANTIATE_GL_TESTS(FrameTest);

} // namespace
} // namespace hachure::test
