#include <hachure/runtime/animation/state_machine.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace hachure::animation {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();

/// idle <-> walk by speed, jump from anywhere by a trigger, and back to idle when the jump is over.
enum : std::uint32_t { idle, walk, jump };
enum : std::uint32_t { speed, armed, jumping };

StateMachine hero() {
    StateMachine machine;
    machine.parameters = {{"speed"}, {"armed", ParameterKind::flag}, {"jump", ParameterKind::trigger}};
    machine.states = {{"idle", 0, {2.0}}, {"walk", 1, {1.0}}, {"jump", 2, {0.5, 1.0, LoopMode::once}}};
    machine.transitions = {
        {any_state, jump, {{jumping, Comparison::set}}, 0.0},
        {idle, walk, {{speed, Comparison::greater, 0.1f}}, 0.4},
        {walk, idle, {{speed, Comparison::less_equal, 0.1f}}, 0.4},
        {jump, idle, {}, 0.2, 1.0},
    };
    return machine;
}

struct Played {
    StateMachine machine;
    std::vector<float> parameters = initial_parameters(machine);
    StateMachineState state{};

    explicit Played(StateMachine of) : machine(std::move(of)) { EXPECT_THAT(check_state_machine(machine), IsEmpty()); }

    void step(double delta) { step_state_machine(machine, parameters, delta, state); }

    [[nodiscard]] float weight_of(std::uint32_t index) const {
        float sum = 0.0f;
        for (const ActiveState& active : state.states())
            if (active.state == index) sum += active.weight;
        return sum;
    }
    [[nodiscard]] const ActiveState& newest() const { return state.states().back(); }
};

TEST(StateMachine, StartsInItsFirstState) {
    Played run(hero());
    run.step(0.0);
    ASSERT_EQ(run.state.count, 1u);
    EXPECT_EQ(run.newest(), (ActiveState{idle, not_started, 0.0, 0.0, 1.0f}));
    run.step(0.25);
    EXPECT_EQ(run.newest(), (ActiveState{idle, 0.0, 0.25, 0.0, 1.0f}));
}

TEST(StateMachine, FadesFromOneStateToTheOther) {
    Played run(hero());
    run.step(1.0);
    run.parameters[speed] = 1.0f;
    run.step(0.1);
    ASSERT_EQ(run.state.count, 2u);
    EXPECT_EQ(run.state.current(), walk);
    EXPECT_FLOAT_EQ(run.weight_of(walk), 0.25f);
    EXPECT_FLOAT_EQ(run.weight_of(idle), 0.75f);
    EXPECT_DOUBLE_EQ(run.newest().time, 0.1);
    EXPECT_EQ(run.newest().previous_time, not_started);
    EXPECT_DOUBLE_EQ(run.state.states()[0].time, 1.1) << "what is faded from goes on";
    run.step(0.2);
    EXPECT_FLOAT_EQ(run.weight_of(walk), 0.75f);
    run.step(0.2);
    ASSERT_EQ(run.state.count, 1u);
    EXPECT_EQ(run.weight_of(walk), 1.0f);
}

TEST(StateMachine, AnInterruptedFadeKeepsWhatWasSeen) {
    Played run(hero());
    run.step(1.0);
    run.parameters[speed] = 1.0f;
    run.step(0.2);
    run.parameters[speed] = 0.0f;
    run.step(0.1);
    ASSERT_EQ(run.state.count, 3u);
    EXPECT_EQ(run.state.current(), idle);
    // The new fade is at a quarter; of the rest, the first fade has gone on to three quarters.
    EXPECT_FLOAT_EQ(run.state.states()[2].weight, 0.25f);
    EXPECT_FLOAT_EQ(run.state.states()[1].weight, 0.75f * 0.75f);
    EXPECT_FLOAT_EQ(run.state.states()[0].weight, 0.75f * 0.25f);
    run.step(0.2);
    EXPECT_EQ(run.state.count, 2u) << "the first fade is over";
    run.step(0.2);
    EXPECT_EQ(run.state.count, 1u);
}

TEST(StateMachine, TriggersAreTakenBackAndFlagsAreNot) {
    Played run(hero());
    run.step(0.1);
    run.parameters[jumping] = 1.0f;
    run.step(0.1);
    EXPECT_EQ(run.state.current(), jump);
    EXPECT_EQ(run.state.count, 1u) << "it jumps without a fade";
    EXPECT_EQ(run.parameters[jumping], 0.0f);

    StateMachine machine = hero();
    machine.transitions = {{any_state, jump, {{armed, Comparison::set}}, 0.0}};
    Played flagged(machine);
    flagged.parameters[armed] = 1.0f;
    flagged.step(0.1);
    EXPECT_EQ(flagged.state.current(), jump);
    EXPECT_EQ(flagged.parameters[armed], 1.0f);
}

TEST(StateMachine, ATriggerThatNobodyTakesStays) {
    StateMachine machine = hero();
    machine.transitions[0].conditions.push_back({armed, Comparison::set});
    Played run(machine);
    run.parameters[jumping] = 1.0f;
    run.step(0.1);
    EXPECT_EQ(run.state.current(), idle);
    EXPECT_EQ(run.parameters[jumping], 1.0f);
    run.parameters[armed] = 1.0f;
    run.step(0.1);
    EXPECT_EQ(run.state.current(), jump);
}

TEST(StateMachine, ExitTimesDoNotDependOnTheFrameRate) {
    for (const double frame : {0.01, 0.07, 0.3, 0.9}) {
        Played run(hero());
        run.parameters[jumping] = 1.0f;
        double time = 0.0;
        for (; time < 0.85; time += frame) run.step(frame);
        EXPECT_EQ(run.state.current(), idle);
        EXPECT_NEAR(run.newest().time, time - 0.5, 1e-9) << frame;
    }
}

TEST(StateMachine, ExitTimesCountSpeedAndOffset) {
    StateMachine machine = hero();
    machine.states[jump].playback = {0.5, -2.0, LoopMode::loop, 0.25};
    machine.transitions[3].exit_time = 3.0;
    Played run(machine);
    run.parameters[jumping] = 1.0f;
    run.step(0.62);
    EXPECT_EQ(run.state.current(), jump);
    run.step(0.01);
    EXPECT_EQ(run.state.current(), idle) << "(3 * 0.5 - 0.25) / 2 = 0.625";
    machine.states[jump].playback.speed = 0.0;
    Played stopped(machine);
    stopped.parameters[jumping] = 1.0f;
    stopped.step(1e6);
    EXPECT_EQ(stopped.state.current(), jump);
}

TEST(StateMachine, AnExitTimeThatIsPastHoldsTheDoorOpen) {
    StateMachine machine = hero();
    machine.transitions = {{idle, walk, {{speed, Comparison::greater, 0.0f}}, 0.0, 0.5}};
    Played run(machine);
    run.step(3.0);
    EXPECT_EQ(run.state.current(), idle);
    run.parameters[speed] = 1.0f;
    run.step(0.25);
    EXPECT_EQ(run.state.current(), walk);
    EXPECT_DOUBLE_EQ(run.newest().time, 0.25);
}

TEST(StateMachine, AnyStateIsNotLeftForItself) {
    StateMachine machine = hero();
    machine.transitions = {{any_state, walk, {{armed, Comparison::set}}, 0.0}};
    Played run(machine);
    run.parameters[armed] = 1.0f;
    run.step(0.1);
    run.step(0.1);
    EXPECT_DOUBLE_EQ(run.newest().time, 0.2);
    run.machine.transitions[0].to_itself = true;
    run.step(0.1);
    EXPECT_DOUBLE_EQ(run.newest().time, 0.1) << "begun again";
}

TEST(StateMachine, TheFirstOfSeveralIsTaken) {
    StateMachine machine = hero();
    machine.transitions = {{idle, walk, {{speed, Comparison::greater, 5.0f}}}, {idle, jump}, {idle, walk}};
    Played run(machine);
    run.step(0.0);
    EXPECT_EQ(run.state.current(), jump);
}

TEST(StateMachine, ComparesInEveryWay) {
    struct Case {
        Comparison comparison;
        bool below, at, above;
    };
    for (const Case& c :
         {Case{Comparison::less, true, false, false}, Case{Comparison::less_equal, true, true, false},
          Case{Comparison::greater, false, false, true}, Case{Comparison::greater_equal, false, true, true},
          Case{Comparison::equal, false, true, false}, Case{Comparison::not_equal, true, false, true},
          Case{Comparison::set, true, true, true}, Case{Comparison::not_set, false, false, false}}) {
        const auto taken = [&](float value) {
            StateMachine machine = hero();
            machine.transitions = {{idle, walk, {{speed, c.comparison, 2.0f}}}};
            Played run(machine);
            run.parameters[speed] = value;
            run.step(0.0);
            return run.state.current() == walk;
        };
        EXPECT_EQ(taken(1.0f), c.below);
        EXPECT_EQ(taken(2.0f), c.at);
        EXPECT_EQ(taken(3.0f), c.above);
        EXPECT_EQ(taken(0.0f), c.comparison == Comparison::not_set || c.below != (c.comparison == Comparison::set));
        EXPECT_FALSE(taken(not_a_number));
    }
}

TEST(StateMachine, RingsOfInstantaneousTransitionsEnd) {
    for (const double duration : {0.0, 0.2}) {
        StateMachine machine = hero();
        machine.transitions = {{idle, walk, {}, duration}, {walk, jump, {}, duration}, {jump, idle, {}, duration}};
        Played run(machine);
        for (int i = 0; i < 5; ++i) {
            run.step(0.1);
            float sum = 0.0f;
            for (const ActiveState& active : run.state.states()) sum += active.weight;
            EXPECT_NEAR(sum, 1.0f, 1e-6f);
            EXPECT_EQ(run.state.current(), idle) << "three transitions lead back";
            EXPECT_DOUBLE_EQ(run.newest().time, 0.1);
        }
    }
    StateMachine itself = hero();
    itself.transitions = {{any_state, idle, {}, 0.0, std::nullopt, true}, {walk, walk}};
    Played run(itself);
    run.step(0.1);
    EXPECT_EQ(run.state.current(), idle);
    EXPECT_DOUBLE_EQ(run.newest().time, 0.1);
}

TEST(StateMachine, ALongStepOverShortStatesEnds) {
    StateMachine machine = hero();
    for (State& state : machine.states) state.playback.duration = 1e-9;
    machine.transitions = {{idle, walk, {}, 0.0, 1.0}, {walk, idle, {}, 0.0, 1.0}};
    Played run(machine);
    run.step(1e6);
    EXPECT_EQ(run.state.current(), idle) << "an even number of transitions";
    for (State& state : run.machine.states) state.playback.duration = 0.0;
    run.step(1.0);
    EXPECT_TRUE(std::isfinite(run.newest().time));
}

TEST(StateMachine, ManyInterruptedFadesKeepTheNewest) {
    StateMachine machine;
    for (int i = 0; i < 8; ++i) machine.states.push_back({std::to_string(i), i, {1.0}});
    machine.parameters = {{"state"}};
    for (std::uint32_t i = 0; i < 8; ++i)
        machine.transitions.push_back({any_state, i, {{0, Comparison::equal, static_cast<float>(i)}}, 1.0});
    Played run(machine);
    for (std::uint32_t i = 0; i < 8; ++i) {
        run.parameters[0] = static_cast<float>(i);
        run.step(0.05);
        EXPECT_EQ(run.state.current(), i);
        EXPECT_EQ(run.state.count, std::min<std::size_t>(i + 1, StateMachineState::most_active));
        float sum = 0.0f;
        for (const ActiveState& active : run.state.states()) sum += active.weight;
        EXPECT_NEAR(sum, 1.0f, 1e-6f);
    }
}

TEST(StateMachine, IsDeterministicAndItsStateIsAllThereIs) {
    std::mt19937 random(6);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    Played first(hero()), second(hero());
    for (int i = 0; i < 2000; ++i) {
        first.parameters[speed] = static_cast<float>(unit(random)) * 0.2f;
        if (random() % 20 == 0) first.parameters[jumping] = 1.0f;
        second.parameters = first.parameters;
        const double delta = 0.1 * unit(random);
        first.step(delta);
        const StateMachineState copy = second.state; // saved and restored
        second.state = {};
        second.state = copy;
        second.step(delta);
        ASSERT_EQ(first.state, second.state);
        ASSERT_EQ(first.parameters, second.parameters);
        float sum = 0.0f;
        for (const ActiveState& active : first.state.states()) {
            ASSERT_GE(active.weight, 0.0f);
            ASSERT_LT(active.previous_time, active.time + 1e-12);
            sum += active.weight;
        }
        ASSERT_NEAR(sum, 1.0f, 1e-6f);
    }
}

TEST(CheckStateMachine, NamesWhatIsWrong) {
    EXPECT_THAT(check_state_machine(hero()), IsEmpty());
    EXPECT_THAT(check_state_machine({}), Contains(HasSubstr("no states")));
    const auto faults = [](auto change) {
        StateMachine machine = hero();
        change(machine);
        return check_state_machine(machine);
    };
    EXPECT_THAT(faults([](StateMachine& m) { m.states[1].name = "idle"; }), Contains(HasSubstr("two states")));
    EXPECT_THAT(faults([](StateMachine& m) { m.parameters[1].name = "speed"; }), Contains(HasSubstr("two parameters")));
    EXPECT_THAT(faults([](StateMachine& m) { m.parameters[0].initial = not_a_number; }),
                Contains(HasSubstr("'speed'")));
    EXPECT_THAT(faults([](StateMachine& m) { m.states[1].playback.speed = not_a_number; }),
                Contains(HasSubstr("'walk'")));
    EXPECT_THAT(faults([](StateMachine& m) { m.states[1].playback.duration = -1; }), Contains(HasSubstr("'walk'")));
    EXPECT_THAT(faults([](StateMachine& m) { m.transitions[1].from = 3; }), Contains(HasSubstr("transition 1 starts")));
    EXPECT_THAT(faults([](StateMachine& m) { m.transitions[1].from = -2; }),
                Contains(HasSubstr("transition 1 starts")));
    EXPECT_THAT(faults([](StateMachine& m) { m.transitions[1].to = 3; }), Contains(HasSubstr("transition 1 leads")));
    EXPECT_THAT(faults([](StateMachine& m) { m.transitions[2].duration = -1; }), Contains(HasSubstr("transition 2")));
    EXPECT_THAT(faults([](StateMachine& m) { m.transitions[3].exit_time = not_a_number; }),
                Contains(HasSubstr("exit time")));
    EXPECT_THAT(faults([](StateMachine& m) { m.transitions[1].conditions[0].parameter = 3; }),
                Contains(HasSubstr("asks for no parameter")));
    EXPECT_THAT(faults([](StateMachine& m) { m.transitions[1].conditions[0].value = not_a_number; }),
                Contains(HasSubstr("compares with no number")));
    EXPECT_EQ(find_state(hero(), "walk"), walk);
    EXPECT_EQ(find_state(hero(), "swim"), std::nullopt);
    EXPECT_EQ(find_parameter(hero(), "jump"), jumping);
}

} // namespace
} // namespace hachure::animation
