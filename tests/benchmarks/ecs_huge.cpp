// Ten million entities inside 4 GiB. What each of them is follows from its number alone, so every sum and count that a
// query gives can be worked out again without a world.

#include <hachure/tests/benchmarks/ecs_components.h>
#include <hachure/tests/benchmarks/ecs_huge.h>
#include <hachure/tests/benchmarks/ecs_measure.h>
#include <hachure/tests/benchmarks/ecs_process.h>

namespace hachure::bench {
namespace {

constexpr double limit_gib = 4.0;
constexpr std::uint32_t tree_span = 50; ///< of so many entities in a row the first five make a tree

/// On every entity: its number.
struct Number {
    std::uint32_t value = 0;
};

/// What the entity of a number is supposed to be. Of its second life, when the first was ended.
struct Plan {
    std::uint32_t number;
    bool second_life;

    /// Which of eight combinations of components.
    [[nodiscard]] std::uint32_t kind() const { return second_life ? (number / 3 + 5) % 8 : number % 8; }
    [[nodiscard]] bool position() const { return kind() != 3 && kind() != 6; }
    [[nodiscard]] bool velocity() const { return kind() != 0 && kind() != 4 && kind() != 6; }
    [[nodiscard]] bool extra() const { return kind() == 2 || kind() == 7; }
    [[nodiscard]] bool sparse() const { return kind() == 5; }
    [[nodiscard]] bool tag() const { return kind() == 3 || kind() == 4 || kind() == 7; }

    /// The number of its parent, or its own: 1, 2 and 3 hang below 0, and 4 below 3. Only first lives have one.
    [[nodiscard]] std::uint32_t parent() const {
        const std::uint32_t place = number % tree_span;
        if (second_life || place == 0 || place > 4) return number;
        return place == 4 ? number - 1 : number - place;
    }
};

/// Whether the entity of this number is destroyed by name; a third of them are, without a pattern.
bool condemned(std::uint32_t number) { return (number * 2654435761u >> 13) % 3 == 0; }

/// Whether it goes: because it is condemned, or something above it is.
bool goes(std::uint32_t number) {
    const std::uint32_t parent = Plan{number, false}.parent();
    return condemned(number) || (parent != number && goes(parent));
}

/// Numbers that are small enough for sums of millions of them to be exact in 64 bits.
Position position_of(std::uint32_t number) { return {static_cast<float>(number % 1000), 1.0f, 2.0f}; }
Velocity velocity_of(std::uint32_t number) { return {static_cast<float>(number % 7), 0.0f, 1.0f}; }

/// Counts and sums over a world, by one definition for the world and another for the plan.
struct Totals {
    std::uint64_t entities = 0, numbers = 0;
    std::uint64_t moving = 0, moved = 0;    ///< with position and velocity, and the sum of x of both
    std::uint64_t tagged = 0, untagged = 0; ///< with position and tag, with position and no tag
    std::uint64_t extras = 0;               ///< among those with a velocity
    std::uint64_t sparse = 0;
    std::uint64_t children = 0, parents = 0, links = 0; ///< the sum of (number of child) * 3 + (number of parent)

    friend bool operator==(const Totals&, const Totals&) = default;
};

class HugeWorld {
public:
    explicit HugeWorld(std::uint32_t count) : count_(count), handles_(count), second_life_(count) {}

    void create() {
        for (std::uint32_t i = 0; i < count_; ++i) handles_[i] = make({i, false});
        for (std::uint32_t i = 0; i < count_; ++i)
            if (const std::uint32_t parent = Plan{i, false}.parent(); parent != i)
                world_.set_parent(handles_[i], handles_[parent]);
    }

    /// Writes to one in eleven, and checks that those are what a query for changes finds.
    void change() {
        const Tick before = world_.tick();
        world_.advance_tick();
        std::uint64_t written = 0, found = 0, expected = 0;
        for (std::uint32_t i = 0; i < count_; i += 11) {
            Position* position = world_.find_mutable<Position>(handles_[i]);
            require((position != nullptr) == plan(i).position(), "a handle finds what its entity has");
            if (!position) continue;
            position->y += 1.0f;
            expected += i;
            ++written;
        }
        for (auto [entity, number, position] :
             world_.query<const Number, const Position>().changed_since<Position>(before)) {
            require(position.y == 2.0f, "a changed position has its new value");
            found += number.value;
            --written;
        }
        require(written == 0 && found == expected, "the query for changes finds what was written");
        // As before, so that the next change starts from the same.
        for (auto [entity, position] : world_.query<Position>().changed_since<Position>(before)) position.y = 1.0f;
    }

    void destroy_a_third() {
        const Tick before = world_.tick();
        world_.advance_tick();
        std::uint64_t gone = 0, positions_gone = 0;
        for (std::uint32_t i = 0; i < count_; ++i) {
            if (condemned(i)) world_.destroy(handles_[i]);
            gone += goes(i) ? 1 : 0;
            positions_gone += goes(i) && Plan{i, false}.position() ? 1 : 0;
        }
        require(world_.size() == count_ - gone, "those and what hung below them are gone");
        require(world_.removed_since<Position>(before).size() == positions_gone, "each lost position is told of once");
        for (std::uint32_t i = 0; i < count_; ++i)
            require(world_.alive(handles_[i]) != goes(i), "handles know who is dead");
        world_.forget_removed_before(world_.tick() + 1);
    }

    void create_again() {
        for (std::uint32_t i = 0; i < count_; ++i) {
            if (!goes(i)) continue;
            const Entity dead = handles_[i];
            second_life_[i] = true;
            handles_[i] = make({i, true});
            require(!world_.alive(dead) && world_.alive(handles_[i]), "a second life has a handle of its own");
        }
    }

    void verify() {
        require(world_.size() == count_, "all entities are there");
        require(counted() == planned(), "counts and sums are those of the plan");
        for (std::uint32_t i = 0; i < count_; i += 997)
            require(world_.get<Number>(handles_[i]).value == i, "a handle leads to its own entity");
    }

private:
    [[nodiscard]] Plan plan(std::uint32_t number) const { return {number, second_life_[number]}; }

    Entity make(const Plan& plan) {
        const Number number{plan.number};
        const Position p = position_of(plan.number);
        const Velocity v = velocity_of(plan.number);
        switch (plan.kind()) {
        case 0:
            return world_.create_with(number, p);
        case 1:
            return world_.create_with(number, p, v);
        case 2:
            return world_.create_with(number, p, v, Extra{});
        case 3:
            return world_.create_with(number, v, Tag{});
        case 4:
            return world_.create_with(number, p, Tag{});
        case 5:
            return world_.create_with(number, p, v, SparseExtra{});
        case 6:
            return world_.create_with(number);
        default:
            return world_.create_with(number, p, v, Tag{}, Extra{});
        }
    }

    [[nodiscard]] Totals planned() const {
        Totals totals;
        for (std::uint32_t i = 0; i < count_; ++i) {
            const Plan one = plan(i);
            ++totals.entities;
            totals.numbers += i;
            const bool moving = one.position() && one.velocity();
            totals.moving += moving ? 1 : 0;
            totals.moved += moving ? i % 1000 + i % 7 : 0;
            totals.tagged += one.position() && one.tag() ? 1 : 0;
            totals.untagged += one.position() && !one.tag() ? 1 : 0;
            totals.extras += one.velocity() && one.extra() ? 1 : 0;
            totals.sparse += one.sparse() ? 1 : 0;
            if (const std::uint32_t parent = one.parent(); parent != i && !second_life_[parent]) {
                ++totals.children;
                totals.links += std::uint64_t{3} * i + parent;
            }
        }
        totals.parents = planned_parents();
        return totals;
    }

    /// Those of which at least one child lives on.
    [[nodiscard]] std::uint64_t planned_parents() const {
        std::uint64_t parents = 0;
        for (std::uint32_t root = 0; root < count_; root += tree_span) {
            const auto lives = [&](std::uint32_t i) { return i < count_ && !second_life_[i]; };
            if (!lives(root)) continue; // nor do those below it
            parents += lives(root + 1) || lives(root + 2) || lives(root + 3) ? 1 : 0;
            parents += lives(root + 3) && lives(root + 4) ? 1 : 0;
        }
        return parents;
    }

    [[nodiscard]] Totals counted() const {
        Totals totals;
        for (auto [entity, number] : world_.query<const Number>()) {
            ++totals.entities;
            totals.numbers += number.value;
        }
        for (auto [entity, position, velocity] : world_.query<const Position, const Velocity>()) {
            ++totals.moving;
            totals.moved += static_cast<std::uint64_t>(position.x + velocity.x);
        }
        totals.tagged = world_.query<const Position, With<Tag>>().count();
        totals.untagged = world_.query<const Position, Without<Tag>>().count();
        for (auto [entity, velocity, extra] : world_.query<const Velocity, Optional<const Extra>>())
            totals.extras += extra ? 1 : 0;
        totals.sparse = world_.query<const SparseExtra>().count();
        for (auto [entity, number, parent] : world_.query<const Number, const Parent>()) {
            ++totals.children;
            totals.links += std::uint64_t{3} * number.value + world_.get<Number>(parent.entity).value;
        }
        totals.parents = world_.query<const Children>().count();
        return totals;
    }

    std::uint32_t count_;
    World world_;
    std::vector<Entity> handles_;   ///< by number
    std::vector<bool> second_life_; ///< by number
};

} // namespace

int run_huge_world(const Arguments& arguments) {
    Report report(arguments);
    HugeWorld world(arguments.quick ? 200'000 : 10'000'000);
    const auto step = [&](const char* name, void (HugeWorld::*work)()) {
        const double start = now_ms();
        (world.*work)();
        report.add(name, now_ms() - start, "ms");
    };
    step("huge: create", &HugeWorld::create);
    step("huge: verify", &HugeWorld::verify);
    step("huge: change and find", &HugeWorld::change);
    step("huge: destroy a third", &HugeWorld::destroy_a_third);
    step("huge: create again", &HugeWorld::create_again);
    step("huge: verify again", &HugeWorld::verify);
    step("huge: change and find again", &HugeWorld::change);
    const double gib = static_cast<double>(peak_resident_bytes()) / (1024.0 * 1024.0 * 1024.0);
    report.add_limited("huge: peak of resident memory", gib, "GiB", limit_gib);
    return report.finish();
}

} // namespace hachure::bench
