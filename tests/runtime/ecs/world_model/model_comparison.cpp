// How the twins are compared.

#include <hachure/tests/runtime/ecs/world_model/model_twins.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace hachure::test::model {

void Twins::compare_sample() {
    for (int i = 0; i < 20; ++i) {
        const Entity entity = any();
        ASSERT_EQ(world_.alive(entity), model_.alive(entity));
        if (model_.alive(entity)) compare_entity(entity, model_.nodes.at(entity));
    }
    compare_plain_query(pick(plain_shapes));
    compare_sparse_query(pick(sparse_shapes));
    compare_change_query(pick(change_shapes));
}

void Twins::compare() {
    ASSERT_EQ(world_.tick(), model_.tick);
    compare_handles();
    for (const auto& [entity, node] : model_.nodes) compare_entity(entity, node);
    std::int64_t counted = 0;
    for (const auto& [entity, node] : model_.nodes)
        counted +=
            (node.has_all<Unique>() ? 1 : 0) + (node.has_all<Text>() ? 1 : 0) + (node.has_all<SparseText>() ? 1 : 0);
    ASSERT_EQ(Instances::live, counted);
    ASSERT_EQ(Instances::faults, 0);
    for (int kind = 0; kind < kinds; ++kind) compare_kind(kind);
    for (std::uint64_t shape = 0; shape < plain_shapes; ++shape) compare_plain_query(shape);
    for (std::uint64_t shape = 0; shape < sparse_shapes; ++shape) compare_sparse_query(shape);
    for (std::uint64_t shape = 0; shape < change_shapes; ++shape) compare_change_query(shape);
}

void Twins::compare_handles() {
    ASSERT_EQ(world_.size(), model_.nodes.size());
    const EntityIds ids = world_.entity_ids();
    std::set<std::uint32_t> free(ids.free.begin(), ids.free.end());
    std::vector<Entity> alive;
    for (std::uint32_t slot = 0; slot < ids.generations.size(); ++slot)
        if (!free.contains(slot)) alive.push_back({slot, ids.generations[slot]});
    ASSERT_EQ(alive, model_.entities());
    for (const Entity entity : known_) ASSERT_EQ(world_.alive(entity), model_.alive(entity));
}

void Twins::compare_entity(Entity entity, const Node& node) {
    ASSERT_TRUE(world_.alive(entity));
    ASSERT_EQ(world_.parent(entity), node.parent);
    ASSERT_EQ(world_.has<Parent>(entity), bool(node.parent));
    ASSERT_TRUE(std::ranges::equal(world_.children(entity), node.children));
    for (int kind = 0; kind < kinds; ++kind) {
        with_kind(kind, [&]<class C>() {
            const C* found = world_.find<C>(entity);
            ASSERT_EQ(found != nullptr, node.has_all<C>());
            ASSERT_EQ(world_.has<C>(entity), node.has_all<C>());
            if (!found) return;
            ASSERT_EQ(found->number(), node.cells[kind]->number);
            ASSERT_EQ(world_.added_tick<C>(entity), node.cells[kind]->added);
            ASSERT_EQ(world_.changed_tick<C>(entity), node.cells[kind]->changed);
        });
    }
}

void Twins::compare_kind(int kind) {
    const Tick since = pick(model_.tick + 1);
    std::vector<Entity> expected;
    Tick latest = 0;
    for (const Removal& removal : model_.removals) {
        if (removal.kind != kind) continue;
        if (removal.tick > since) expected.push_back(removal.entity);
        latest = std::max(latest, removal.tick);
    }
    for (const auto& [entity, node] : model_.nodes)
        if (node.cells[kind]) latest = std::max(latest, node.cells[kind]->changed);
    with_kind(kind, [&]<class C>() {
        // In order of time; the order within a tick is the world's own.
        const auto told = world_.removed_since<C>(since);
        std::vector<Entity> removed(told.begin(), told.end());
        std::ranges::sort(removed);
        std::ranges::sort(expected);
        ASSERT_EQ(removed, expected);
        // A changed component may be gone without trace of its change, so the latest known is a lower bound.
        ASSERT_GE(world_.last_changed<C>(), latest);
        ASSERT_LE(world_.last_changed<C>(), world_.tick());
    });
}

/// The query visits those nodes for which `matches(node)` holds, each once, and reads what they carry.
template <class Query, class Matches> void Twins::compare_query(const Query& query, Matches matches) {
    std::vector<Entity> visited;
    for (auto it = query.begin(); it != query.end(); ++it) visited.push_back(it.entity());
    ASSERT_EQ(query.count(), visited.size());
    ASSERT_EQ(query.empty(), visited.empty());
    ASSERT_EQ(query.first(), visited.empty() ? Entity::null : visited.front());
    std::size_t steps = 0;
    query.each(
        [&](Entity entity, const auto&...) { ASSERT_EQ(entity, visited.at(steps++)) << "each goes another way"; });
    ASSERT_EQ(steps, visited.size());
    std::ranges::sort(visited);
    std::vector<Entity> expected;
    for (const auto& [entity, node] : model_.nodes)
        if (matches(node)) expected.push_back(entity);
    ASSERT_EQ(visited, expected);
}

void Twins::compare_plain_query(std::uint64_t shape) {
    const World& world = world_;
    switch (shape) {
    case 0:
        compare_query(world.query<const Triple, const Text>(),
                      [](const Node& node) { return node.has_all<Triple, Text>(); });
        break;
    case 1:
        compare_query(world.query<Without<Triple, Text>>(),
                      [](const Node& node) { return !node.has_any<Triple, Text>(); });
        break;
    case 2:
        compare_query(world.query<const Unique, With<Mark, Large>>(),
                      [](const Node& node) { return node.has_all<Unique, Mark, Large>(); });
        break;
    case 3:
        compare_query(world.query<Optional<const Large>, const Children, Without<Parent>>(),
                      [](const Node& node) { return !node.children.empty() && !node.parent; });
        break;
    case 4:
        compare_query(world.query<const Parent, const Mark>(),
                      [](const Node& node) { return node.parent && node.has_all<Mark>(); });
        for (auto [entity, parent] : world.query<const Parent>())
            ASSERT_EQ(parent.entity, model_.nodes.at(entity).parent);
        break;
    default:
        // References lead to the components of the entity that is visited.
        for (auto [entity, aligned, text, unique] :
             world.query<const Aligned32, Optional<const Text>, const Unique, Without<Large>>()) {
            ASSERT_EQ(&aligned, world.find<Aligned32>(entity));
            ASSERT_EQ(text, world.find<Text>(entity));
            ASSERT_EQ(&unique, world.find<Unique>(entity));
        }
        compare_query(world.query<const Aligned32, Optional<const Text>, const Unique, Without<Large>>(),
                      [](const Node& node) { return node.has_all<Aligned32, Unique>() && !node.has_any<Large>(); });
    }
}

void Twins::compare_sparse_query(std::uint64_t shape) {
    const World& world = world_;
    switch (shape) {
    case 0:
        compare_query(world.query<const SparseTriple>(), [](const Node& node) { return node.has_all<SparseTriple>(); });
        break;
    case 1:
        compare_query(world.query<const Text, const SparseText, Without<SparseMark>>(),
                      [](const Node& node) { return node.has_all<Text, SparseText>() && !node.has_any<SparseMark>(); });
        break;
    case 2:
        compare_query(world.query<With<SparseMark, SparseTriple>>(),
                      [](const Node& node) { return node.has_all<SparseMark, SparseTriple>(); });
        break;
    case 3:
        compare_query(world.query<AnyOf<const SparseMark, const Large>, Without<Triple>>(),
                      [](const Node& node) { return node.has_any<SparseMark, Large>() && !node.has_any<Triple>(); });
        break;
    case 4:
        compare_query(world.query<AnyOf<const Unique, const Aligned64>>(),
                      [](const Node& node) { return node.has_any<Unique, Aligned64>(); });
        break;
    case 5:
        compare_query(
            world.query<OfParent<const SparseTriple>, Optional<const SparseText>>(),
            [this](const Node& node) { return node.parent && model_.nodes.at(node.parent).has_all<SparseTriple>(); });
        break;
    case 6:
        compare_query(world.query<OfParent<const Triple>, const SparseMark>(), [this](const Node& node) {
            return node.parent && model_.nodes.at(node.parent).has_all<Triple>() && node.has_all<SparseMark>();
        });
        break;
    default:
        // References lead to the components of the entity that is visited.
        for (auto [entity, triple, text, mark, aligned, above] :
             world.query<const SparseTriple, Optional<const SparseText>, AnyOf<const SparseMark, const Aligned32>,
                         Optional<OfParent<const Text>>>()) {
            ASSERT_EQ(&triple, world.find<SparseTriple>(entity));
            ASSERT_EQ(text, world.find<SparseText>(entity));
            ASSERT_EQ(mark, world.find<SparseMark>(entity));
            ASSERT_EQ(aligned, world.find<Aligned32>(entity));
            ASSERT_EQ(above, world.find<Text>(world.parent(entity)));
        }
    }
}

/// The same through the queue and through the sweep.
template <class Query, class Matches> void Twins::compare_changes(const Query& query, Matches matches) {
    using detail::ChangeWalk;
    for (const ChangeWalk how : {ChangeWalk::queue, ChangeWalk::sweep, ChangeWalk::automatic})
        compare_query(query.finding_changes(how), matches);
}

void Twins::compare_change_query(std::uint64_t shape) {
    const World& world = world_;
    // Mostly a few ticks ago, at times anywhere.
    const Tick since = once_in(3) ? pick(model_.tick + 1) : model_.tick - std::min(model_.tick, pick(5));
    switch (shape) {
    case 0:
        compare_changes(world.query<const Triple>().changed_since<Triple>(since),
                        [since](const Node& node) { return node.changed_since<Triple>(since); });
        break;
    case 1:
        compare_changes(world.query<const Text, Without<Mark>>().changed_since<Triple, Text, Aligned64>(since),
                        [since](const Node& node) {
                            return node.has_all<Text>() && !node.has_any<Mark>() &&
                                   (node.changed_since<Triple>(since) || node.changed_since<Text>(since) ||
                                    node.changed_since<Aligned64>(since));
                        });
        break;
    case 2:
        compare_changes(
            world.query<Optional<const Large>>().added_since<Large, Unique>(since),
            [since](const Node& node) { return node.added_since<Large>(since) || node.added_since<Unique>(since); });
        break;
    case 3:
        compare_changes(world.query<const SparseText>().changed_since<SparseText>(since),
                        [since](const Node& node) { return node.changed_since<SparseText>(since); });
        break;
    case 4:
        compare_changes(world.query<With<SparseMark>>().added_since<SparseMark, SparseTriple, Text>(since),
                        [since](const Node& node) {
                            return node.has_all<SparseMark>() &&
                                   (node.added_since<SparseMark>(since) || node.added_since<SparseTriple>(since) ||
                                    node.added_since<Text>(since));
                        });
        break;
    case 5:
        compare_changes(world.query<AnyOf<const Triple, const SparseTriple>>()
                            .changed_since<SparseTriple>(since)
                            .changed_since<Text>(since),
                        [since](const Node& node) {
                            return node.changed_since<SparseTriple>(since) && node.changed_since<Text>(since);
                        });
        break;
    default:
        compare_changes(world.query<const Mark>().added_since<Mark>(since).changed_since<Unique, Aligned32>(since),
                        [since](const Node& node) {
                            return node.added_since<Mark>(since) &&
                                   (node.changed_since<Unique>(since) || node.changed_since<Aligned32>(since));
                        });
    }
}

} // namespace hachure::test::model
