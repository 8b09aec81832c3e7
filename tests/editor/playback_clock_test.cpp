#include <hachure/components/animation.h>
#include <hachure/components/implicit_brush.h>
#include <hachure/components/morph_weights.h>
#include <hachure/components/rig.h>
#include <hachure/components/shade_strokes.h>
#include <hachure/components/transform.h>
#include <hachure/editor/frame_walk.h>
#include <hachure/editor/playback_clock.h>
#include <hachure/runtime/ecs/time.h>
#include <hachure/runtime/scene/scene_parts.h>
#include <hachure/systems/animation/animation.h>
#include <hachure/systems/deform/deform.h>
#include <hachure/systems/model/spawn_model.h>
#include <hachure/systems/shade_strokes/shade_strokes.h>
#include <hachure/systems/transform/transform.h>
#include <hachure/tests/support/arm_model.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace hachure::test {
namespace {

TEST(PlaybackClock, SeeksFromWhereverItIs) {
    App app;
    app.run_frame(seek(app, 0.5));
    EXPECT_EQ(app.world().resource<Time>().elapsed, 0.5);
    for (const double seconds : {0.5, 0.75, 100.0, 100.1}) {
        app.run_frame(seek(app, seconds));
        EXPECT_DOUBLE_EQ(app.world().resource<Time>().elapsed, seconds);
    }
}

/// Stands for any component that the types call "script": the command line knows it by that name alone.
struct Stateful {
    std::int64_t sum = 0; ///< grows from frame to frame
};

void reflect(TypeBuilder<Stateful>& type) {
    type.name("script").doc("Counts frames.");
    type.field("sum", &Stateful::sum).doc("so far");
}

TEST(PlaybackClock, ScriptsNeedStepping) {
    App app;
    const Entity entity = app.world().create();
    EXPECT_FALSE(needs_stepping(app));
    app.add_component<Stateful>();
    EXPECT_FALSE(needs_stepping(app)) << "nobody carries one";
    app.world().add(entity, Stateful{});
    EXPECT_TRUE(needs_stepping(app));
}

TEST(PlaybackClock, StepsWhereNoiseIsCarriedAlong) {
    App app;
    const Entity brush = app.world().create_with(ImplicitBrush{.grain = BrushGrain::solid});
    EXPECT_FALSE(needs_stepping(app));
    app.world().get_mutable<ImplicitBrush>(brush).grain = BrushGrain::advected;
    EXPECT_TRUE(needs_stepping(app));
}

/// Strokes depend on how the light came to be what it is.
TEST(PlaybackClock, StepsWhereShadeIsKeptUp) {
    App app;
    register_shade_strokes(app);
    EXPECT_FALSE(needs_stepping(app));
    app.world().create_with(ShadeStrokes{});
    EXPECT_TRUE(needs_stepping(app));
}

/// Of no reflected type.
struct Score {};

TEST(PlaybackClock, TimelinesNeedSteppingThatAreOnlyPartsOfScenes) {
    App app;
    ScenePart part;
    part.name = "timeline";
    part.write = [](const World& world, Entity entity) {
        return world.has<Score>(entity) ? std::optional<nlohmann::json>(nlohmann::json::object()) : std::nullopt;
    };
    add_scene_part(app.world(), part);
    app.world().create();
    EXPECT_FALSE(needs_stepping(app));
    app.world().create_with(Score{});
    EXPECT_TRUE(needs_stepping(app));
}

/// What a state that builds up is in the frames that a run draws.
std::vector<std::int64_t> sums(const std::string& frames, const std::vector<std::int64_t>& wanted) {
    App app;
    app.add_component<Stateful>();
    const Entity entity = app.world().create_with(Stateful{});
    app.add_system(Stage::script, "count", [](Query<Stateful> all, const Time& time) {
        all.each([&](Stateful& state) { state.sum = 3 * state.sum + static_cast<std::int64_t>(time.delta * 1e6) + 1; });
    });
    std::vector<std::int64_t> result;
    const FrameHistory history = needs_stepping(app) ? FrameHistory::whole : FrameHistory::none;
    walk_frames(parse_frame_plan(frames, "", "30"), wanted, history, [&](const FrameStep& step) {
        app.run_frame(seek(app, step.seconds));
        if (step.drawn) result.push_back(app.world().get<Stateful>(entity).sum);
    });
    return result;
}

TEST(PlaybackClock, FrameKIsTheSameWhereverARunBegins) {
    const std::vector<std::int64_t> all = sums("0..9", {0, 1, 2, 3, 4, 5, 6, 7, 8, 9});
    EXPECT_EQ(sums("7..9", {7, 8, 9}), (std::vector<std::int64_t>{all[7], all[8], all[9]}));
    EXPECT_EQ(sums("0..9", {2, 5}), (std::vector<std::int64_t>{all[2], all[5]})) << "as --resume leaves them";
}

/// What a clip shows in a frame: places of all nodes, weights of all targets.
struct Shown {
    std::vector<Transform> places;
    std::vector<float> weights;
};

Shown shown(const char* clip, std::int64_t frame, FrameHistory history, const char* fps) {
    App app;
    register_transform(app);
    register_animation(app);
    register_deform(app);
    const SpawnedModel model = spawn_model(app.world(), arm_model());
    app.world().add(model.root, Animation{.clip = clip});
    walk_frames(parse_frame_plan(std::to_string(frame), "", fps), std::vector{frame}, history,
                [&](const FrameStep& step) { app.run_frame(seek(app, step.seconds)); });
    Shown result;
    const Rig& rig = app.world().get<Rig>(model.root);
    for (const Entity node : rig.nodes) result.places.push_back(app.world().get<Transform>(node));
    app.world().query<const MorphWeights>().each([&](const MorphWeights& morph) {
        result.weights.insert(result.weights.end(), morph.values.begin(), morph.values.end());
    });
    return result;
}

/// Clips at their own speed: their time is the frame's, and seeking loses no bit of that.
TEST(PlaybackClock, AClipShowsTheSameAfterAJumpAndAfterSteps) {
    for (const char* clip : {"bend", "walk", "swell"})
        for (const char* fps : {"30", "29.97", "24"})
            for (const std::int64_t frame : {1, 2, 17, 100, 251}) {
                const Shown jump = shown(clip, frame, FrameHistory::none, fps);
                const Shown steps = shown(clip, frame, FrameHistory::whole, fps);
                ASSERT_EQ(jump.places.size(), steps.places.size());
                for (std::size_t i = 0; i < jump.places.size(); ++i) {
                    EXPECT_EQ(jump.places[i].translation, steps.places[i].translation) << clip << ' ' << frame;
                    EXPECT_EQ(jump.places[i].rotation, steps.places[i].rotation) << clip << ' ' << frame;
                }
                EXPECT_EQ(jump.weights, steps.weights) << clip << ' ' << frame;
            }
}

} // namespace
} // namespace hachure::test
