#include <hachure/runtime/ecs/schedule.h>
#include <hachure/tests/runtime/ecs/thread_limit.h>

#include <gtest/gtest.h>

#include <array>
#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <random>
#include <string>
#include <thread>
#include <vector>

// Random schedules over random data: whatever a system can see goes into its own log, and logs and worlds must be the
// same with any number of threads. All numbers are integers of 64 bits, so "the same" is bit for bit.

namespace hachure {
namespace {

using Number = std::uint64_t;

template <int n> struct Part { Number value = 0; };
using A = Part<0>;
using B = Part<1>;
using C = Part<2>;

template <int n> struct Total { Number value = 1; };

struct Note {
    Number from = 0;
    Number value = 0;
};

Number mix(Number a, Number b) {
    Number x = a * 0x9e37'79b9'7f4a'7c15u + b + 1;
    x ^= x >> 29;
    x *= 0xbf58'476d'1ce4'e5b9u;
    return x ^ x >> 32;
}

Number number(Entity entity) { return (Number{entity.generation} << 32) | entity.index; }

/// What a system saw so far, as one number.
struct Log {
    Number seed = 0;
    Number seen = 0;
    Number runs = 0;
    void see(Number value) { seen = mix(seen, value); }

    /// Begins a run of the system, at times late, so that a later one overtakes it if nothing keeps it from that.
    void begin() {
        if (mix(seed, ++runs) % 4 == 0 && thread_limit() > 1)
            std::this_thread::sleep_for(std::chrono::microseconds(20));
    }
};

/// The kinds of systems that schedules are drawn from. Each keeps its log.
using Kind = std::function<SystemHandle(Schedule&, Stage, std::string, Log&)>;

template <class Read, class Write>
SystemHandle add_transfer(Schedule& schedule, Stage stage, std::string name, Log& log) {
    return schedule.add(stage, std::move(name), [&log](Query<const Read, Write> query, LastRun last) {
        log.begin();
        for (auto [entity, read, write] : query.template changed_since<Read>(last.tick)) {
            write.value = mix(write.value + log.seed, read.value);
            log.see(number(entity));
        }
    });
}

template <class Read, int n> SystemHandle add_sum(Schedule& schedule, Stage stage, std::string name, Log& log) {
    return schedule.add(stage, std::move(name), [&log](Query<const Read> query, Total<n>& total, LastRun last) {
        log.begin();
        query.each([&](const Read& read) { total.value = mix(total.value, read.value); });
        log.see(query.template changed_since<const Read>(last.tick).count());
    });
}

template <class Write, int n> SystemHandle add_spread(Schedule& schedule, Stage stage, std::string name, Log& log) {
    return schedule.add(stage, std::move(name),
                        [&log](Query<Write, Without<A>> query, const Total<n>& total, LastRun last) {
                            log.begin();
                            query.each([&](Entity entity, Write& write) {
                                if ((number(entity) + total.value) % 3 == 0)
                                    write.value = mix(total.value, write.value);
                            });
                            log.see(mix(total.value, last.tick));
                        });
}

SystemHandle add_spawner(Schedule& schedule, Stage stage, std::string name, Log& log) {
    return schedule.add(stage, std::move(name), [&log](Commands& commands, Query<const A> query) {
        log.begin();
        const Number count = query.count();
        for (Number i = 0; i < 1 + log.seed % 3; ++i) {
            const Entity made = commands.create();
            commands.add(made, A{mix(count, log.seed)});
            if (i % 2 == 0) commands.add(made, B{count});
            log.see(number(made));
        }
    });
}

SystemHandle add_reaper(Schedule& schedule, Stage stage, std::string name, Log& log) {
    return schedule.add(stage, std::move(name), [&log](Commands& commands, Query<const C> query, Removed<B> removed) {
        log.begin();
        query.each([&](Entity entity, const C& c) {
            if (c.value % 5 == log.seed % 5) commands.destroy(entity);
            if (c.value % 7 == 3) commands.remove<B>(entity);
            if (c.value % 7 == 4) commands.add(entity, A{c.value});
        });
        for (const Entity entity : removed) log.see(number(entity));
    });
}

SystemHandle add_sender(Schedule& schedule, Stage stage, std::string name, Log& log) {
    return schedule.add(stage, std::move(name), [&log](EventWriter<Note> notes, Query<const B> query) {
        log.begin();
        query.each([&](const B& b) {
            if (b.value % 4 == 1) notes.send({log.seed, b.value});
        });
    });
}

SystemHandle add_listener(Schedule& schedule, Stage stage, std::string name, Log& log) {
    return schedule.add(stage, std::move(name), [&log](EventReader<Note> notes, Query<C> query) {
        log.begin();
        for (const Note& note : notes) log.see(mix(note.from, note.value));
        const Number sum = log.seen;
        query.each([&](C& c) { c.value = mix(c.value, sum); });
    });
}

SystemHandle add_exclusive(Schedule& schedule, Stage stage, std::string name, Log& log) {
    return schedule.add(stage, std::move(name), [&log](World& world) {
        log.begin();
        log.see(world.tick());
        log.see(number(world.create_with(B{log.seed}, C{world.size()})));
    });
}

SystemHandle add_census(Schedule& schedule, Stage stage, std::string name, Log& log) {
    return schedule.add(stage, std::move(name), [&log](const World& world, LastRun last) {
        log.begin();
        for (auto [entity, c] : world.query<const C>().changed_since<C>(last.tick)) log.see(number(entity));
        log.see(world.size());
    });
}

const std::vector<Kind>& kinds() {
    static const std::vector<Kind> all{
        add_transfer<A, B>, add_transfer<B, C>, add_transfer<C, A>, add_sum<A, 0>, add_sum<B, 1>,
        add_spread<B, 1>,   add_spread<C, 0>,   add_spawner,        add_reaper,    add_sender,
        add_listener,       add_listener,       add_exclusive,      add_census,
    };
    return all;
}

/// One schedule and its world, both given by a seed.
class Game {
public:
    explicit Game(Number seed) : random_(seed) {
        world_.set_resource(Total<0>{});
        world_.set_resource(Total<1>{});
        for (Number i = 0; i < 40; ++i) {
            const Entity entity = world_.create();
            if (random_() % 2 == 0) world_.add(entity, A{random_()});
            if (random_() % 2 == 0) world_.add(entity, B{random_()});
            if (random_() % 2 == 0) world_.add(entity, C{random_()});
        }
        schedule_.set_fixed_step(0.25, 3);
        for (int i = 0; i < 14; ++i) add_system(i);
    }

    void run() {
        for (int i = 0; i < 10; ++i) schedule_.run(world_, static_cast<double>(random_() % 8) / 16);
    }

    /// Everything that there is to see.
    std::vector<Number> state() const {
        std::vector<Number> state{world_.tick(), world_.size(), world_.resource<Total<0>>().value,
                                  world_.resource<Total<1>>().value};
        for (const auto& log : logs_) state.push_back(log->seen);
        add_column<A>(state);
        add_column<B>(state);
        add_column<C>(state);
        for (const Note& note : events_since<Note>(world_, 0)) state.push_back(mix(note.from, note.value));
        for (const Entity entity : world_.removed_since<B>(0)) state.push_back(number(entity));
        return state;
    }

    bool saw_something() const {
        int busy = 0;
        for (const auto& log : logs_) busy += log->seen != 0;
        return busy > 5;
    }

private:
    void add_system(int i) {
        logs_.push_back(std::make_unique<Log>(Log{random_()}));
        const Stage stage = random_() % 3 == 0 ? Stage::input : Stage::script;
        SystemHandle handle = kinds()[random_() % kinds().size()](schedule_, stage, std::to_string(i), *logs_.back());
        const bool fixed = random_() % 5 == 0;
        if (fixed) handle.fixed();
        // A smaller number in the same part and stage is never after a greater one, so there is no cycle.
        std::vector<int>& place = places_[fixed][stage == Stage::script];
        if (!place.empty() && random_() % 3 == 0) handle.after(std::to_string(place[random_() % place.size()]));
        place.push_back(i);
        if (random_() % 5 == 0) handle.run_if([](const Total<1>& total) { return total.value % 3 != 0; });
    }

    template <class T> void add_column(std::vector<Number>& state) const {
        for (auto [entity, part] : world_.query<const T>())
            state.insert(state.end(),
                         {number(entity), part.value, world_.changed_tick<T>(entity), world_.added_tick<T>(entity)});
        state.push_back(world_.last_changed<T>());
    }

    std::mt19937_64 random_;
    World world_;
    Schedule schedule_;
    std::vector<std::unique_ptr<Log>> logs_;
    std::vector<int> places_[2][2];
};

TEST(ScheduleDeterminismTest, ThreadsDoNotChangeTheResult) {
    int busy = 0;
    for (Number seed = 0; seed < 80; ++seed) {
        std::vector<std::vector<Number>> states;
        for (const int threads : {1, 4, 4}) {
            const test::ThreadLimit limit(threads);
            Game game(seed);
            game.run();
            states.push_back(game.state());
            busy += game.saw_something();
        }
        ASSERT_EQ(states[0], states[1]) << "seed " << seed;
        ASSERT_EQ(states[0], states[2]) << "seed " << seed;
    }
    EXPECT_GT(busy, 200) << "the schedules do something";
}

/// Notes how many entities had their T changed.
template <class T> struct Reader {
    Log* log;
    void operator()(Query<const T> query, LastRun last) {
        log->begin();
        log->see(query.template changed_since<T>(last.tick).count());
    }
};

/// The same, and changes them now and then.
template <class T> struct Writer {
    Log* log;
    Number runs = 0;
    void operator()(Query<T> query, LastRun last) {
        log->begin();
        log->see(query.template changed_since<T>(last.tick).count());
        if (mix(log->seed, ++runs) % 3 == 0) query.each([](T& part) { ++part.value; });
    }
};

/// The same system with the world for itself, so that nothing runs beside it; it notes its last run by hand.
template <class System, class Term> struct Alone {
    System system;
    Tick last = 0;
    void operator()(World& world) {
        system(world.query<Term>(), LastRun{last});
        last = world.tick();
    }
};

template <class T> void add_reader_or_writer(Schedule& schedule, const std::string& name, Log& log, bool beside) {
    const bool writes = log.seed % 2 == 0;
    if (writes && beside) schedule.add(Stage::script, name, Writer<T>{&log});
    if (writes && !beside) schedule.add(Stage::script, name, Alone<Writer<T>, T>{{&log}});
    if (!writes && beside) schedule.add(Stage::script, name, Reader<T>{&log});
    if (!writes && !beside) schedule.add(Stage::script, name, Alone<Reader<T>, const T>{{&log}});
}

/// Random systems that read or write one part, run beside each other or each alone; what each saw changed.
std::vector<Number> changes_seen(Number seed, bool beside) {
    std::mt19937_64 random(seed);
    World world;
    for (int i = 0; i < 6; ++i) world.create_with(A{}, B{}, C{});
    Schedule schedule;
    std::vector<Log> logs(8);
    for (std::size_t i = 0; i < logs.size(); ++i) {
        logs[i].seed = random();
        constexpr std::array kinds{add_reader_or_writer<A>, add_reader_or_writer<B>, add_reader_or_writer<C>};
        kinds[random() % 3](schedule, std::to_string(i), logs[i], beside);
    }
    for (int i = 0; i < 12; ++i) schedule.run(world);
    std::vector<Number> seen{world.tick()};
    for (const Log& log : logs) seen.push_back(log.seen);
    for (auto [entity, a] : world.query<const A>()) seen.push_back(world.changed_tick<A>(entity));
    return seen;
}

TEST(ScheduleDeterminismTest, ChangesAreSeenAsInLinearOrder) {
    const test::ThreadLimit limit(4);
    for (Number seed = 0; seed < 100; ++seed)
        ASSERT_EQ(changes_seen(seed, true), changes_seen(seed, false)) << "seed " << seed;
}

} // namespace
} // namespace hachure
