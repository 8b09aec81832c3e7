#include <hachure/runtime/ecs/events.h>
#include <hachure/runtime/ecs/schedule.h>
#include <hachure/tests/runtime/ecs/thread_limit.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <iterator>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace hachure {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

struct Hit {
    int damage = 0;
    bool operator==(const Hit&) const = default;
};

std::vector<int> damages(const EventRange<Hit>& hits) {
    std::vector<int> result;
    for (const Hit& hit : hits) result.push_back(hit.damage);
    return result;
}

TEST(EventsTest, EveryReaderSeesEachEventOnce) {
    World world;
    Schedule schedule;
    std::vector<int> early, late;
    int next = 0;
    const auto collect = [](std::vector<int>& into) {
        return [&into](EventReader<Hit> hits) {
            for (const Hit& hit : hits) into.push_back(hit.damage);
        };
    };
    schedule.add(Stage::input, "early", collect(early));
    schedule.add(Stage::script, "send", [&](EventWriter<Hit> hits) {
        hits.send({++next});
        hits.send({++next});
    });
    schedule.add(Stage::render, "late", collect(late));
    for (int i = 0; i < 3; ++i) schedule.run(world);
    EXPECT_THAT(late, ElementsAre(1, 2, 3, 4, 5, 6));
    EXPECT_THAT(early, ElementsAre(1, 2, 3, 4)) << "what comes after it is seen in the next run";
}

TEST(EventsTest, SendersInOneStageKeepTheirOrder) {
    for (const int threads : {1, 4}) {
        const test::ThreadLimit limit(threads);
        World world;
        Schedule schedule;
        std::vector<int> seen;
        for (int sender = 0; sender < 5; ++sender)
            schedule.add(Stage::script, std::to_string(sender), [sender](EventWriter<Hit> hits) {
                for (int i = 0; i < 3; ++i) hits.send({10 * sender + i});
            });
        schedule.add(Stage::script, "reader", [&](EventReader<Hit> hits) { seen = damages(hits); });
        schedule.run(world);
        EXPECT_THAT(seen, ElementsAre(0, 1, 2, 10, 11, 12, 20, 21, 22, 30, 31, 32, 40, 41, 42));
    }
}

TEST(EventsTest, ASystemDoesNotSeeItsOwnAndMaySendWhileReading) {
    World world;
    Schedule schedule;
    std::vector<int> seen;
    schedule.add(Stage::script, "echo", [&](EventReader<Hit> in, EventWriter<Hit> out) {
        for (const Hit& hit : in) {
            for (int i = 0; i < 1000; ++i) out.send({-1}); // moves no event that is being read
            seen.push_back(hit.damage);
        }
    });
    send_event(world, Hit{1});
    send_event(world, Hit{2});
    schedule.run(world);
    schedule.run(world);
    send_event(world, Hit{3});
    schedule.run(world);
    EXPECT_THAT(seen, ElementsAre(1, 2, 3));
}

TEST(EventsTest, ProgramsSendAndReadOutsideOfSystems) {
    World world;
    EXPECT_THAT(damages(events_since<Hit>(world, 0)), IsEmpty());
    send_event(world, Hit{1});
    world.advance_tick();
    send_event(world, Hit{2});
    EXPECT_THAT(damages(events_since<Hit>(world, 0)), ElementsAre(1, 2));
    EXPECT_THAT(damages(events_since<Hit>(world, 1)), ElementsAre(2));
    EXPECT_THAT(damages(events_since<Hit>(world, 2)), IsEmpty());
}

TEST(EventsTest, OldOnesAreForgotten) {
    World world;
    Schedule schedule;
    schedule.add(Stage::script, "send", [](EventWriter<Hit> hits) { hits.send({1}); });
    for (int i = 0; i < 100; ++i) schedule.run(world);
    EXPECT_LE(world.resource<EventQueue<Hit>>().size(), 3u);
    EXPECT_GE(world.resource<EventQueue<Hit>>().size(), 1u);
}

TEST(EventsTest, OnesThatNoSystemNamesAreForgottenOnRequest) {
    World world;
    Schedule schedule;
    schedule.add(Stage::script, "send", [](World& w) { send_event(w, Hit{1}); });
    for (int i = 0; i < 10; ++i) schedule.run(world);
    EXPECT_EQ(world.resource<EventQueue<Hit>>().size(), 10u);
    schedule.add_event<Hit>();
    schedule.run(world);
    EXPECT_LE(world.resource<EventQueue<Hit>>().size(), 3u);
}

TEST(EventsTest, FixedSystemsMissNoneInFramesWithoutAStep) {
    World world;
    Schedule schedule;
    schedule.set_fixed_step(1.0);
    std::vector<int> seen;
    int next = 0;
    schedule.add(Stage::input, "send", [&](EventWriter<Hit> hits) { hits.send({next++}); });
    schedule
        .add(Stage::script, "read",
             [&](EventReader<Hit> hits) {
                 for (const Hit& hit : hits) seen.push_back(hit.damage);
             })
        .fixed();
    for (int i = 0; i < 64; ++i) schedule.run(world, 0.125);
    std::vector<int> expected(64);
    for (int i = 0; i < 64; ++i) expected[static_cast<std::size_t>(i)] = i;
    EXPECT_EQ(seen, expected);
    EXPECT_LE(world.resource<EventQueue<Hit>>().size(), 20u) << "two steps' worth";
}

TEST(EventsTest, MayBeMoveOnly) {
    World world;
    Schedule schedule;
    int seen = 0;
    schedule.add(Stage::input, "send",
                 [](EventWriter<std::unique_ptr<int>> out) { out.send(std::make_unique<int>(7)); });
    schedule.add(Stage::script, "read", [&](EventReader<std::unique_ptr<int>> in) {
        for (const auto& event : in) seen += *event;
    });
    schedule.run(world);
    schedule.run(world);
    EXPECT_EQ(seen, 14);
}

TEST(EventsTest, AConditionOnEventsSparesTheSystem) {
    World world;
    Schedule schedule;
    std::vector<std::vector<int>> seen;
    schedule.add(Stage::script, "react", [&](EventReader<Hit> hits) { seen.push_back(damages(hits)); })
        .run_if([](EventReader<Hit> hits) { return !hits.empty(); });
    schedule.run(world);
    send_event(world, Hit{1});
    schedule.run(world);
    schedule.run(world);
    send_event(world, Hit{2});
    send_event(world, Hit{3});
    schedule.run(world);
    EXPECT_THAT(seen, ElementsAre(ElementsAre(1), ElementsAre(2, 3)));
}

TEST(EventsTest, IteratorsAreForward) {
    static_assert(std::forward_iterator<EventRange<Hit>::Iterator>);
    EventQueue<Hit> queue;
    queue.send({1}, 1);
    queue.send({2}, 1);
    const EventRange<Hit> range = queue.since(0);
    auto it = range.begin();
    EXPECT_EQ((it++)->damage, 1);
    EXPECT_EQ(it->damage, 2);
    EXPECT_EQ(++it, range.end());
    EXPECT_EQ(range.size(), 2u);
}

TEST(EventsDeathTest, TimeDoesNotRunBackwards) {
    EventQueue<Hit> queue;
    queue.send({1}, 5);
    EXPECT_DEATH(queue.send({1}, 4), "in order of time");
}

} // namespace
} // namespace hachure
