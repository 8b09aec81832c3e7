#include <hachure/runtime/ecs/schedule.h>
#include <hachure/tests/runtime/ecs/components.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace hachure {
namespace {

using namespace test;
using testing::ElementsAre;
using testing::HasSubstr;

struct Breeze {
    double speed = 0;
};
struct Blow {
    int damage = 0;
};

template <class F> detail::SystemNeeds needs_of(F system) {
    static_assert(detail::check_system<F>());
    return detail::make_callable(std::move(system))->needs();
}

std::vector<std::string> described(const std::vector<Access::Item>& items) {
    std::vector<std::string> result;
    for (const Access::Item& item : items) {
        const std::string name(item.name.substr(item.name.rfind(':') + 1));
        result.push_back((item.writes ? "writes " : "reads ") + name);
    }
    std::ranges::sort(result);
    return result;
}

TEST(SystemParamTest, TermsOfQueriesAreReadOrWritten) {
    const Access access =
        needs_of([](Query<const Position, Speed, With<Hidden>, Without<Owner>>, Query<Optional<Label>>) {}).access;
    EXPECT_THAT(described(access.components), ElementsAre("reads Position", "writes Label", "writes Speed"));
    EXPECT_THAT(access.resources, testing::IsEmpty());
    const Access optional = needs_of([](Query<Optional<const Position>>) {}).access;
    EXPECT_THAT(described(optional.components), ElementsAre("reads Position"));
}

TEST(SystemParamTest, ConstnessOfResourcesIsTheirAccess) {
    EXPECT_THAT(described(needs_of([](const Breeze&) {}).access.resources), ElementsAre("reads Breeze"));
    EXPECT_THAT(described(needs_of([](const Breeze*) {}).access.resources), ElementsAre("reads Breeze"));
    EXPECT_THAT(described(needs_of([](Breeze&) {}).access.resources), ElementsAre("writes Breeze"));
    EXPECT_THAT(described(needs_of([](Breeze*) {}).access.resources), ElementsAre("writes Breeze"));
}

TEST(SystemParamTest, TheOthers) {
    EXPECT_TRUE(needs_of([](World&) {}).access.exclusive);
    EXPECT_TRUE(needs_of([](const World&) {}).access.reads_world);
    EXPECT_TRUE(needs_of([](Commands&) {}).access.commands);
    EXPECT_FALSE(needs_of([](LastRun, Removed<Speed>) {}).access.writes());
    const detail::SystemNeeds reader = needs_of([](EventReader<Blow>) {});
    const detail::SystemNeeds writer = needs_of([](EventWriter<Blow>) {});
    EXPECT_FALSE(reader.access.writes());
    EXPECT_TRUE(conflicts(reader.access, writer.access));
    EXPECT_TRUE(conflicts(writer.access, writer.access));
    EXPECT_EQ(reader.events.size(), 1u);
}

TEST(SystemParamTest, KnowsWhatASystemCanTake) {
    using detail::SystemParameter;
    static_assert(SystemParameter<Query<const Position>> && SystemParameter<const Breeze&> && SystemParameter<Breeze*>);
    static_assert(SystemParameter<Removed<Speed>> && SystemParameter<EventReader<Blow>> && SystemParameter<LastRun>);
    static_assert(!SystemParameter<int> && !SystemParameter<int&> && !SystemParameter<Breeze> &&
                  !SystemParameter<Breeze&&>);
    static_assert(!SystemParameter<Commands> && !SystemParameter<const Commands&> && !SystemParameter<World*>);
    static_assert(!SystemParameter<Query<Position>&> && !SystemParameter<const EventReader<Blow>&>);
    const auto overloaded = [](auto&&...) {};
    static_assert(!detail::HasSignature<decltype(overloaded)>);
    SUCCEED() << "checked by the compiler";
}

void slow_down(Query<Speed> speeds) {
    speeds.each([](Speed& speed) { speed.value /= 2; });
}
void slow_down_quietly(Query<Speed> speeds) noexcept { slow_down(speeds); }

/// Runs `system` once on a world with one Speed of 1.
template <class F> double speed_after(F system) {
    World world;
    const Entity entity = world.create_with(Speed{1});
    Schedule schedule;
    schedule.add(Stage::script, "system", std::move(system));
    schedule.run(world);
    return world.get<Speed>(entity).value;
}

TEST(SystemParamTest, AnyCallableWithOneSignatureIsASystem) {
    struct Constant {
        void operator()(Query<Speed> speeds) const { slow_down(speeds); }
    };
    struct Lvalue {
        void operator()(Query<Speed> speeds) & noexcept { slow_down(speeds); }
    };
    EXPECT_EQ(speed_after(slow_down), 0.5);
    EXPECT_EQ(speed_after(&slow_down_quietly), 0.5);
    EXPECT_EQ(speed_after([](Query<Speed> speeds) { slow_down(speeds); }), 0.5);
    EXPECT_EQ(speed_after([](const Query<Speed> speeds) mutable noexcept { slow_down(speeds); }), 0.5);
    EXPECT_EQ(speed_after(Constant{}), 0.5);
    EXPECT_EQ(speed_after(Lvalue{}), 0.5);
    EXPECT_EQ(speed_after(std::function<void(Query<Speed>)>(slow_down)), 0.5);
    EXPECT_EQ(speed_after([owned = std::make_unique<int>(1)](Query<Speed> speeds) { slow_down(speeds); }), 0.5);
    EXPECT_EQ(speed_after([] {}), 1);
}

TEST(SystemParamTest, ResourcesArriveAndMustBeThereByReference) {
    World world;
    Schedule schedule;
    int runs = 0;
    const Breeze* seen = nullptr;
    schedule.add(Stage::input, "pointer", [&](const Breeze* wind) { seen = wind; });
    schedule.add(Stage::script, "reference", [&](const Breeze& wind) { runs += wind.speed > 0; });
    try {
        schedule.run(world);
        FAIL() << "nothing thrown";
    } catch (const MissingResource& error) {
        EXPECT_THAT(error.what(), HasSubstr("Breeze"));
    }
    EXPECT_EQ(seen, nullptr);
    const Breeze& wind = world.set_resource(Breeze{3});
    schedule.run(world);
    EXPECT_EQ(seen, &wind);
    EXPECT_EQ(runs, 1);
}

TEST(SystemParamTest, ResourcesCanBeWritten) {
    World world;
    world.set_resource(Breeze{3});
    Schedule schedule;
    schedule.add(Stage::input, "by reference", [](Breeze& wind) { wind.speed *= 2; });
    schedule.add(Stage::input, "by pointer", [](Breeze* wind) { wind->speed += 1; });
    schedule.run(world);
    EXPECT_EQ(world.resource<Breeze>().speed, 7);
}

TEST(SystemParamTest, AFunctorKeepsItsStateBetweenRuns) {
    struct Counter {
        std::vector<int>* seen;
        int runs = 0;
        void operator()(LastRun) { seen->push_back(++runs); }
    };
    World world;
    std::vector<int> seen;
    Schedule schedule;
    schedule.add(Stage::script, "counter", Counter{&seen});
    for (int i = 0; i < 3; ++i) schedule.run(world);
    EXPECT_THAT(seen, ElementsAre(1, 2, 3));
}

TEST(SystemParamTest, TheWorldIsReadAsAWhole) {
    World world;
    world.create_with(Speed{2});
    Schedule schedule;
    std::size_t seen = 0;
    schedule.add(Stage::script, "census", [&](const World& w) { seen = w.query<const Speed>().count() + w.size(); });
    schedule.run(world);
    EXPECT_EQ(seen, 2u);
}

} // namespace
} // namespace hachure
