// The world against a model of it made of std::map, under random operations. HACHURE_ECS_OPERATIONS (default 20000 per
// seed) and HACHURE_ECS_SEED (default: four fixed seeds) widen or repeat the search.

#include <hachure/runtime/ecs/commands.h>
#include <hachure/runtime/ecs/world.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <optional>
#include <random>
#include <string>
#include <vector>

namespace hachure {
namespace {

/// Three component types with the same content; one of them owns memory.
struct Red {
    std::string text;
};
struct Green {
    std::string text;
};
struct Blue {
    std::string text;
};

struct Cell {
    std::string text;
    Tick added;
    Tick changed;
};

struct Node {
    std::optional<Cell> cells[3];
    Entity parent;
    std::vector<Entity> children;
};

struct Removal {
    int type;
    Entity entity;
    Tick tick;
};

/// What a world is supposed to be, without any care for speed.
struct Model {
    std::map<Entity, Node> nodes;
    std::vector<Removal> removals;
    Tick tick = 1;

    bool has(Entity entity, int type) { return nodes.contains(entity) && nodes.at(entity).cells[type].has_value(); }

    void add(Entity entity, int type, const std::string& text) {
        auto& cell = nodes.at(entity).cells[type];
        cell = Cell{text, cell ? cell->added : tick, tick};
    }

    void remove(Entity entity, int type) {
        nodes.at(entity).cells[type].reset();
        removals.push_back({type, entity, tick});
    }

    bool contains(Entity ancestor, Entity entity) {
        for (; entity; entity = nodes.at(entity).parent)
            if (entity == ancestor) return true;
        return false;
    }

    void unlink(Entity entity) {
        Node& node = nodes.at(entity);
        if (node.parent) std::erase(nodes.at(node.parent).children, entity);
        node.parent = Entity::null;
    }

    void link(Entity entity, Entity parent) {
        if (nodes.at(entity).parent == parent) return;
        unlink(entity);
        nodes.at(entity).parent = parent;
        nodes.at(parent).children.push_back(entity);
    }

    void destroy(Entity entity) {
        unlink(entity);
        while (!nodes.at(entity).children.empty()) destroy(nodes.at(entity).children.front());
        for (int type = 0; type < 3; ++type)
            if (has(entity, type)) remove(entity, type);
        nodes.erase(entity);
    }
};

template <class F> auto with_type(int type, F f) {
    if (type == 0) return f(Red{});
    if (type == 1) return f(Green{});
    return f(Blue{});
}

/// Runs the same operations on a world and on its model.
class Twins {
public:
    explicit Twins(std::uint64_t seed) : random_(seed) {}

    void step() {
        const auto dice = pick(100);
        if (dice < 14) return create();
        if (dice < 20) return destroy();
        if (dice < 45) return add();
        if (dice < 55) return remove();
        if (dice < 70) return write();
        if (dice < 82) return set_parent();
        if (dice < 85) return clear_parent();
        if (dice < 93) return use_commands();
        if (dice < 97) return sweep();
        advance_tick();
    }

    void compare() {
        ASSERT_EQ(world_.size(), model_.nodes.size());
        ASSERT_EQ(world_.tick(), model_.tick);
        for (const auto& [entity, node] : model_.nodes) compare_entity(entity, node);
        for (int type = 0; type < 3; ++type) compare_type(type);
        const Tick since = pick(model_.tick + 1);
        const auto query = world_.query<const Red, Optional<const Green>, Without<Blue>>();
        std::size_t expected = 0;
        for (const auto& [entity, node] : model_.nodes)
            expected += node.cells[0] && !node.cells[2] && node.cells[0]->changed > since;
        ASSERT_EQ(query.changed_since<Red>(since).count(), expected);
        for (auto [entity, red, green] : query) {
            const Node& node = model_.nodes.at(entity);
            ASSERT_TRUE(node.cells[0] && !node.cells[2]);
            ASSERT_EQ(red.text, node.cells[0]->text);
            ASSERT_EQ(green != nullptr, node.cells[1].has_value());
            if (green) {
                ASSERT_EQ(green->text, node.cells[1]->text);
            }
        }
    }

private:
    std::uint64_t pick(std::uint64_t n) { return random_() % n; }
    int any_type() { return static_cast<int>(pick(3)); }
    std::string any_text() { return std::string(pick(40), static_cast<char>('a' + pick(26))); }

    /// Any handle ever given out: about half of them are dead.
    Entity any() { return known_.empty() ? Entity::null : known_[pick(known_.size())]; }
    bool alive(Entity entity) { return model_.nodes.contains(entity); }

    void remember(Entity entity) {
        ASSERT_FALSE(alive(entity));
        model_.nodes[entity];
        if (known_.size() < 300)
            known_.push_back(entity);
        else
            known_[pick(known_.size())] = entity;
    }

    void create() {
        // Small worlds meet their edge cases more often.
        if (model_.nodes.size() > 200) return;
        remember(world_.create());
    }

    void destroy() {
        const Entity entity = any();
        ASSERT_EQ(world_.destroy(entity), alive(entity));
        if (alive(entity)) model_.destroy(entity);
    }

    void add() {
        const Entity entity = any();
        const int type = any_type();
        const std::string text = any_text();
        with_type(type, [&](auto component) {
            component.text = text;
            if (!alive(entity)) {
                EXPECT_THROW(world_.add(entity, component), DeadEntity);
            } else {
                EXPECT_EQ(world_.add(entity, component).text, text);
                model_.add(entity, type, text);
            }
        });
    }

    void remove() {
        const Entity entity = any();
        const int type = any_type();
        const bool had = model_.has(entity, type);
        with_type(type, [&]<class C>(C) { EXPECT_EQ(world_.remove<C>(entity), had); });
        if (had) model_.remove(entity, type);
    }

    void write() {
        const Entity entity = any();
        const int type = any_type();
        const std::string text = any_text();
        const bool had = model_.has(entity, type);
        with_type(type, [&]<class C>(C) {
            C* found = world_.find_mutable<C>(entity);
            ASSERT_EQ(found != nullptr, had);
            if (found) found->text = text;
        });
        if (had) model_.add(entity, type, text);
    }

    void set_parent() {
        const Entity child = any();
        const Entity parent = any();
        if (!alive(child) || !alive(parent)) {
            ASSERT_THROW(world_.set_parent(child, parent), DeadEntity);
        } else if (model_.contains(child, parent)) {
            ASSERT_THROW(world_.set_parent(child, parent), HierarchyCycle);
        } else {
            world_.set_parent(child, parent);
            model_.link(child, parent);
        }
    }

    void clear_parent() {
        const Entity child = any();
        world_.clear_parent(child);
        if (alive(child)) model_.unlink(child);
    }

    void advance_tick() {
        world_.advance_tick();
        ++model_.tick;
        if (pick(10) != 0) return;
        const Tick before = model_.tick - std::min(model_.tick, pick(20));
        world_.forget_removed_before(before);
        std::erase_if(model_.removals, [before](const Removal& removal) { return removal.tick < before; });
    }

    /// Queues changes of what a query walks; the model makes them afterwards, in the same order.
    void use_commands() {
        std::vector<std::pair<Entity, int>> plan;
        Commands& commands = world_.commands();
        for (auto [entity, red] : world_.query<const Red>()) {
            const int what = static_cast<int>(pick(10));
            if (what == 0) commands.destroy(entity);
            if (what == 1) commands.remove<Green>(entity);
            if (what == 2) commands.add(entity, Blue{red.text + "!"});
            if (what <= 2) plan.emplace_back(entity, what);
        }
        const Entity made = commands.create();
        commands.add(made, Red{"made"});
        ASSERT_FALSE(world_.alive(made));
        std::vector<std::string> texts;
        for (const auto& [entity, what] : plan) texts.push_back(model_.nodes.at(entity).cells[0]->text + "!");
        world_.apply_commands();
        for (std::size_t i = 0; i < plan.size(); ++i) {
            const auto& [entity, what] = plan[i];
            if (!alive(entity)) continue; // went with an ancestor
            if (what == 0) model_.destroy(entity);
            if (what == 1 && model_.has(entity, 1)) model_.remove(entity, 1);
            if (what == 2) model_.add(entity, 2, texts[i]);
        }
        remember(made);
        model_.add(made, 0, "made");
    }

    /// Writes through a query.
    void sweep() {
        for (auto [entity, green, blue] : world_.query<Green, Optional<Blue>, Without<Red>>()) {
            green.text += "+";
            if (blue) blue->text = "swept";
        }
        for (auto& [entity, node] : model_.nodes) {
            if (!node.cells[1] || node.cells[0]) continue;
            model_.add(entity, 1, node.cells[1]->text + "+");
            if (node.cells[2]) model_.add(entity, 2, "swept");
        }
    }

    void compare_entity(Entity entity, const Node& node) {
        ASSERT_TRUE(world_.alive(entity));
        ASSERT_EQ(world_.parent(entity), node.parent);
        ASSERT_TRUE(std::ranges::equal(world_.children(entity), node.children));
        for (int type = 0; type < 3; ++type) {
            with_type(type, [&]<class C>(C) {
                const C* found = world_.find<C>(entity);
                ASSERT_EQ(found != nullptr, node.cells[type].has_value());
                if (!found) return;
                ASSERT_EQ(found->text, node.cells[type]->text);
                ASSERT_EQ(world_.added_tick<C>(entity), node.cells[type]->added);
                ASSERT_EQ(world_.changed_tick<C>(entity), node.cells[type]->changed);
            });
        }
    }

    void compare_type(int type) {
        const Tick since = pick(model_.tick + 1);
        std::vector<Entity> expected;
        Tick latest = 0;
        for (const Removal& removal : model_.removals) {
            if (removal.type != type) continue;
            if (removal.tick > since) expected.push_back(removal.entity);
            latest = std::max(latest, removal.tick);
        }
        for (const auto& [entity, node] : model_.nodes)
            if (node.cells[type]) latest = std::max(latest, node.cells[type]->changed);
        with_type(type, [&]<class C>(C) {
            const auto removed = world_.removed_since<C>(since);
            // In order of time; the order within a tick is the world's own.
            ASSERT_TRUE(std::ranges::is_permutation(removed, expected));
            // A changed component may be gone without trace of its change, so the latest known is a lower bound.
            ASSERT_GE(world_.last_changed<C>(), latest);
            ASSERT_LE(world_.last_changed<C>(), world_.tick());
        });
    }

    std::mt19937_64 random_;
    World world_;
    Model model_;
    std::vector<Entity> known_;
};

std::uint64_t from_environment(const char* name, std::uint64_t fallback) {
    const char* text = std::getenv(name);
    return text ? std::strtoull(text, nullptr, 10) : fallback;
}

TEST(WorldModelTest, BehavesAsTheModel) {
    const std::uint64_t operations = from_environment("HACHURE_ECS_OPERATIONS", 20'000);
    const std::uint64_t fixed = from_environment("HACHURE_ECS_SEED", 0);
    for (const std::uint64_t seed : fixed ? std::vector{fixed} : std::vector<std::uint64_t>{1, 2, 3, 4}) {
        Twins twins(seed);
        for (std::uint64_t i = 1; i <= operations; ++i) {
            twins.step();
            if (i % 500 == 0) twins.compare();
            if (testing::Test::HasFailure()) FAIL() << "seed " << seed << ", operation " << i;
        }
    }
}

} // namespace
} // namespace hachure
