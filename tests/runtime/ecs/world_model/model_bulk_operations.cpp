// What the twins do to many entities at once, through queries and queues, and to the world as a whole.

#include <hachure/runtime/ecs/commands.h>
#include <hachure/runtime/ecs/ecs_error.h>
#include <hachure/tests/runtime/ecs/world_model/model_twins.h>

#include <gtest/gtest.h>

#include <algorithm>

namespace hachure::test::model {

void Twins::rarely() {
    if (full() && once_in(2)) return destroy_many(); // or nothing would be created in bulk any more
    const auto dice = pick(1000);
    if (dice < 300) return create_many();
    if (dice < 600) return create_each();
    if (dice < 800) return destroy_many();
    if (dice < 860) return destroy_matching();
    if (dice < 910) return instantiate();
    if (dice < 930) return move_world();
    if (dice < 940) return clear();
    if (dice < 970) return restore_entities();
    begin_again_with_same_handles();
}

void Twins::create_many() {
    if (full()) return;
    const std::uint32_t n = any_number();
    const std::size_t count = pick(most_ / 2);
    const bool sparse = once_in(3);
    const bool marked = !sparse && once_in(2);
    const std::vector<Entity> made =
        sparse   ? world_.create_many(count, SparseText::make(n), Triple::make(n), SparseMark{}, Text::make(n))
        : marked ? world_.create_many(count, Text::make(n), Triple::make(n), Mark{})
                 : world_.create_many(count, Triple::make(n), Text::make(n));
    ASSERT_EQ(made.size(), count);
    for (const Entity entity : made) {
        remember(entity);
        model_.put<Triple>(entity, n);
        model_.put<Text>(entity, n);
        if (marked) model_.put<Mark>(entity, 0);
        if (sparse) model_.put<SparseText>(entity, n);
        if (sparse) model_.put<SparseMark>(entity, 0);
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
    if (once_in(3)) {
        // By whole tables, some of them in trees.
        world_.destroy_matching(world_.query<With<Aligned32>, Without<Text>>());
        for (const Entity entity : model_.entities()) {
            if (!model_.alive(entity)) continue; // went with an ancestor
            const Node& node = model_.nodes.at(entity);
            if (node.has_all<Aligned32>() && !node.has_any<Text>()) model_.destroy(entity);
        }
        return;
    }
    const Tick since = model_.tick - std::min(model_.tick, pick(3));
    world_.destroy_matching(world_.query<const Triple, Without<Large>>().changed_since<Triple>(since));
    for (const Entity entity : model_.entities()) {
        if (!model_.alive(entity)) continue; // went with an ancestor
        const Node& node = model_.nodes.at(entity);
        if (node.changed_since<Triple>(since) && !node.has_any<Large>()) model_.destroy(entity);
    }
}

void Twins::instantiate() {
    const Entity prefab = any();
    if (!model_.alive(prefab)) {
        ASSERT_THROW(world_.instantiate(prefab), DeadEntity);
        return;
    }
    std::vector<Entity> originals = world_.descendants(prefab);
    originals.insert(originals.begin(), prefab);
    const std::size_t most = full() ? 0 : (most_ - model_.nodes.size()) / originals.size();
    for (const Entity copy : world_.instantiate_many(prefab, std::min<std::size_t>(most, pick(20)))) {
        std::vector<Entity> copies = world_.descendants(copy);
        copies.insert(copies.begin(), copy);
        ASSERT_EQ(copies.size(), originals.size());
        for (std::size_t i = 0; i < copies.size(); ++i) {
            remember(copies[i]);
            const Node original = model_.nodes.at(originals[i]);
            for (int kind = 0; kind < kinds; ++kind)
                if (kind != kind_of<Unique> && original.cells[kind])
                    model_.put(copies[i], kind, original.cells[kind]->number);
            if (i == 0) continue;
            const auto parent = std::ranges::find(originals, original.parent) - originals.begin();
            model_.link(copies[i], copies[static_cast<std::size_t>(parent)]);
        }
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
    if (once_in(3)) {
        for (auto [entity, triple, text] : world_.query<SparseTriple, Optional<SparseText>, Without<Large>>()) {
            const std::uint32_t n = triple.number() + 1;
            triple = SparseTriple::make(n);
            if (text) *text = SparseText::make(n);
            visited.push_back(entity);
            if (visited.size() >= most_visits) break;
        }
        for (const Entity entity : visited) {
            const Node& node = model_.nodes.at(entity);
            ASSERT_TRUE(node.has_all<SparseTriple>() && !node.has_any<Large>());
            const std::uint32_t n = node.cells[kind_of<SparseTriple>]->number + 1;
            if (node.has_all<SparseText>()) model_.put<SparseText>(entity, n);
            model_.put<SparseTriple>(entity, n);
        }
        return;
    }
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
        if (next.what == 6) commands.add(entity, SparseText::make(next.number));
        if (next.what == 7) commands.remove<SparseTriple>(entity);
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
        if (what == 6) model_.put<SparseText>(entity, number);
        if (what == 7 && model_.has(entity, kind_of<SparseTriple>)) model_.remove(entity, kind_of<SparseTriple>);
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
