// What runs every frame allocates nothing once it has run.

#include <hachure/runtime/animation/blend.h>
#include <hachure/runtime/animation/root_motion.h>
#include <hachure/runtime/animation/state_machine.h>
#include <hachure/runtime/animation/timeline_events.h>
#include <hachure/tests/runtime/animation/allocation_count.h>
#include <hachure/tests/runtime/animation/clip_builder.h>

#include <gtest/gtest.h>

#include <memory>
#include <vector>

namespace hachure::animation {
namespace {

template <typename Work> std::size_t allocations_of(Work&& work) {
    work(); // the first run may make room
    const std::size_t before = test::allocation_count();
    for (int i = 0; i < 10; ++i) work();
    return test::allocation_count() - before;
}

TEST(Allocations, AreCounted) {
    EXPECT_GE(allocations_of([] { EXPECT_EQ(std::make_unique<std::vector<int>>(1000)->size(), 1000u); }), 10u);
}

TEST(Allocations, PosesNeedNone) {
    ModelBuilder builder(3, 2);
    builder.clip("c");
    builder.channel(0, AnimationPath::rotation, {0, 1}, {0, 0, 0, 1, 0, 1, 0, 0});
    builder.channel(1, AnimationPath::weights, {0, 2}, {0, 0, 1, 1}, Interpolation::linear, 2);
    const ClipSet set = builder.compile();
    Pose a = rest_pose(builder.model, set.layout), b = a, out = a;
    SampleCache cache;
    cache.reserve(set.clips[0]);
    const std::size_t before = test::allocation_count();
    SampleClipJob first{&set.clips[0], 0.5, &cache, a.span()};
    first.validate();
    first.run();
    EXPECT_EQ(test::allocation_count() - before, 0u) << "there is room from the first run on";
    EXPECT_EQ(allocations_of([&] {
                  SampleClipJob sample{&set.clips[0], 0.7, &cache, a.span()};
                  sample.run();
                  const BlendLayer layers[]{{a.span(), 0.5f}, {b.span(), 0.5f}};
                  BlendPosesJob blend{layers, b.span(), out.span(), &set.layout};
                  blend.validate();
                  blend.run();
                  OverlayPoseJob overlay{out.span(), a.span(), 0.5f, {}, &set.layout};
                  overlay.run();
                  AddPoseJob add{out.span(), a.span(), b.span(), 0.5f, {}, &set.layout};
                  add.run();
                  const Playback playback{1.0, 1.0, LoopMode::loop};
                  EXPECT_EQ(root_motion_between(set.clips[0], {}, {}, playback, 0.5, 3.5).translation, glm::dvec3(0.0));
              }),
              0u);
}

TEST(Allocations, EventsAndStatesNeedNone) {
    const std::vector<TimelineEvent> events{{0.1, "a"}, {0.2, "b"}};
    std::vector<PassedEvent> passed;
    StateMachine machine;
    machine.states = {{"a", 0, {1.0}}, {"b", 1, {1.0}}};
    machine.transitions = {{0, 1, {}, 0.2, 1.0}, {1, 0, {}, 0.2, 1.0}};
    std::vector<float> parameters;
    StateMachineState state;
    EXPECT_EQ(allocations_of([&] {
                  PassedEventsJob job{events, {1.0, 1.0, LoopMode::loop}, 0.0, 5.0, &passed};
                  job.validate();
                  job.run();
                  step_state_machine(machine, parameters, 0.9, state);
              }),
              0u);
    EXPECT_EQ(passed.size(), 10u);
}

} // namespace
} // namespace hachure::animation
