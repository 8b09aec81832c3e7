// What the twins do to many entities at once, through queries and queues, and to the world as a whole.

#include <hachure/runtime/ecs/commands.h>
#include <hachure/tests/runtime/ecs/model_twins.h>

#include <gtest/gtest.h>

#include <algorithm>

namespace hachure::test::model {

void Twins::rarely() {
    if (full() && once_in(2)) return destroy_many(); // or nothing would be created in bulk any more
    const auto dice = pick(1000);
    if (dice < 300) return create_many();
    if (dice < 600) return create_each();
    if (dice < 800) return destroy_many();
    if (dice < 900) return destroy_matching();
    if (dice < 930) return move_world();
    if (dice < 940) return clear();
    if (dice < 970) return restore_entities();
    begin_again_with_same_handles();
}

void Twins::create_many() {
    if (full()) return;
    const std::uint32_t n = any_number();
    const std::size_t count = pick(most_ / 2);
    const std::vector<Entity> made = once_in(2) ? world_.create_many(count, Triple::make(n), Text::make(n))
                                                : world_.create_many(count, Text::make(n), Triple::make(n), Mark{});
    ASSERT_EQ(made.size(), count);
    for (const Entity entity : made) {
        remember(entity);
        model_.put<Triple>(entity, n);
        model_.put<Text>(entity, n);
        if (world_.has<Mark>(entity)) model_.put<Mark>(entity, 0);
    }
}

void Twins::create_each() {
    if (full()) return;
    std::size_t made = 0;
    const std::size_t count = pick(most_ / 2);
    const std::uint32_t first = any_number();
    world_.create_each<Unique, Aligned64>(count, [&](std::size_t i, Entity entity, Unique& unique, Aligned64& aligned) {
        ASSERT_EQ(i, made++);
        const std::uint32_t n = first + static_cast<std::uint32_t>(i);
        unique = Unique::make(n);
        aligned = Aligned64::make(n);
        remember(entity);
        model_.put<Unique>(entity, n);
        model_.put<Aligned64>(entity, n);
    });
    ASSERT_EQ(made, count);
}

void Twins::destroy_many() {
    std::vector<Entity> some;
    for (std::uint64_t i = pick(most_ / 4); i > 0; --i) some.push_back(any()); // dead ones and repetitions included
    world_.destroy_many(some);
    for (const Entity entity : some)
        if (model_.alive(entity)) model_.destroy(entity);
}

void Twins::destroy_matching() {
    const Tick since = model_.tick - std::min(model_.tick, pick(3));
    world_.destroy_matching(world_.query<const Triple, Without<Large>>().changed_since<Triple>(since));
    for (const Entity entity : model_.entities()) {
        if (!model_.alive(entity)) continue; // went with an ancestor
        const Node& node = model_.nodes.at(entity);
        if (node.changed_since<Triple>(since) && !node.has_any<Large>()) model_.destroy(entity);
    }
}

void Twins::clear() {
    world_.clear();
    model_.clear();
}

void Twins::sweep() {
    // All the way is rare in a large world; half way is a case of its own.
    const std::size_t most_visits = once_in(1 + most_ / 100) ? model_.nodes.size() : pick(30);
    std::vector<Entity> visited;
    for (auto [entity, aligned, text] : world_.query<Aligned64, Optional<Text>, Without<Aligned32>>()) {
        aligned.value += 1;
        if (text) *text = Text::make(aligned.value);
        visited.push_back(entity);
        if (visited.size() >= most_visits) break;
    }
    for (const Entity entity : visited) {
        const Node& node = model_.nodes.at(entity);
        ASSERT_TRUE(node.has_all<Aligned64>() && !node.has_any<Aligned32>());
        const std::uint32_t n = node.cells[kind_of<Aligned64>]->number + 1;
        if (node.has_all<Text>()) model_.put<Text>(entity, n);
        model_.put<Aligned64>(entity, n);
    }
}

void Twins::sweep_with_each() {
    const Tick since = model_.tick - std::min(model_.tick, pick(3));
    const auto recent = world_.query<Triple, With<Text>>().changed_since<Text>(since);
    recent.each([](Triple& triple) { triple = Triple::make(triple.number() + 1); });
    for (auto& [entity, node] : model_.nodes)
        if (node.has_all<Triple>() && node.changed_since<Text>(since))
            model_.put<Triple>(entity, node.cells[kind_of<Triple>]->number + 1);
}

void Twins::use_commands() {
    struct Planned {
        Entity entity;
        std::uint64_t what;
        std::uint32_t number;
    };
    std::vector<Planned> plan;
    Commands& commands = world_.commands();
    const Entity made = commands.create();
    commands.add(made, Unique::make(1));
    for (auto [entity, triple] : world_.query<const Triple>()) {
        const Planned next{entity, pick(12), any_number()};
        if (next.what == 0) commands.destroy(entity);
        if (next.what == 1) commands.remove<Text>(entity);
        if (next.what == 2) commands.add(entity, Unique::make(next.number));
        if (next.what == 3) commands.add(entity, Aligned32::make(next.number));
        if (next.what == 4) commands.set_parent(entity, made);
        if (next.what == 5) commands.clear_parent(entity);
        plan.push_back(next);
        if (plan.size() >= 40) break;
    }
    ASSERT_FALSE(world_.alive(made));
    world_.apply_commands();
    remember(made);
    model_.put<Unique>(made, 1);
    for (const auto& [entity, what, number] : plan) {
        if (!model_.alive(entity)) continue; // went with an ancestor
        if (what == 0) model_.destroy(entity);
        if (what == 1 && model_.has(entity, kind_of<Text>)) model_.remove(entity, kind_of<Text>);
        if (what == 2) model_.put<Unique>(entity, number);
        if (what == 3) model_.put<Aligned32>(entity, number);
        if (what == 4) model_.link(entity, made);
        if (what == 5) model_.unlink(entity);
    }
}

void Twins::advance_tick() {
    ASSERT_EQ(world_.advance_tick(), ++model_.tick);
    if (!once_in(10)) return;
    const Tick before = model_.tick - std::min(model_.tick, pick(20));
    world_.forget_removed_before(before);
    model_.forget_removed_before(before);
}

void Twins::move_world() {
    World by_construction(std::move(world_));
    World by_assignment;
    by_assignment.create_with(Text::make(1), Unique::make(2)); // to be lost
    by_assignment = std::move(by_construction);
    world_ = std::move(by_assignment);
}

void Twins::restore_entities() {
    const std::vector<Entity> alive = model_.entities();
    world_.restore_entities(world_.entity_ids());
    model_.clear();
    for (const Entity entity : alive) model_.nodes[entity];
}

void Twins::begin_again_with_same_handles() {
    World fresh;
    fresh.restore_entities(world_.entity_ids());
    const Entity next = fresh.create();
    ASSERT_EQ(next, world_.create()) << "the restored world gives out the same handles";
    const std::vector<Entity> alive = model_.entities();
    world_ = std::move(fresh);
    model_ = WorldModel();
    for (const Entity entity : alive) model_.nodes[entity];
    remember(next);
    compare_handles();
}

} // namespace hachure::test::model
