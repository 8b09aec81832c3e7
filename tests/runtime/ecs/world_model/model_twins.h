#pragma once

#include <hachure/runtime/ecs/world.h>
#include <hachure/tests/runtime/ecs/world_model/world_model.h>

#include <cstddef>
#include <cstdint>
#include <random>
#include <span>
#include <vector>

namespace hachure::test::model {

/// Runs the same random operations on a world and on its model, and compares the two. Every difference is a failure of
/// the running test.
class Twins {
public:
    /// Keeps to about `most` entities: small worlds meet their edge cases more often, large ones fill more storage.
    Twins(std::uint64_t seed, std::size_t most) : random_(seed), most_(most) {}

    /// One operation.
    void step();

    /// Compares a few entities and one query.
    void compare_sample();

    /// Compares everything that can be asked.
    void compare();

private:
    // Choices. `any` gives one of the handles ever given out; some of them are dead.
    std::uint64_t pick(std::uint64_t n) { return random_() % n; }
    bool once_in(std::uint64_t n) { return pick(n) == 0; }
    std::uint32_t any_number() { return static_cast<std::uint32_t>(pick(4096)); }
    int any_kind() { return static_cast<int>(pick(kinds)); }
    Entity any() { return known_.empty() ? Entity::null : known_[pick(known_.size())]; }
    bool full() const { return model_.nodes.size() >= most_; }

    /// Takes an entity that the world has made into the model.
    void remember(Entity entity);

    // Operations on one entity.
    void create();
    void create_with_some();
    void destroy();
    void add();
    void remove();
    void write();
    void set_parent();
    void clear_parent();

    // Operations on many, or on the world.
    void rarely();
    void create_many();
    void create_each();
    void destroy_many();
    void destroy_matching();
    void clear();
    void sweep();
    void sweep_with_each();
    void use_commands();
    void advance_tick();
    void instantiate();
    void move_world();
    void restore_entities();
    void begin_again_with_same_handles();

    // Comparisons.
    void compare_entity(Entity entity, const Node& node);
    void compare_kind(int kind);
    void compare_handles();
    static constexpr std::uint64_t plain_shapes = 6;
    static constexpr std::uint64_t sparse_shapes = 8;
    static constexpr std::uint64_t change_shapes = 7;
    void compare_plain_query(std::uint64_t shape);
    void compare_change_query(std::uint64_t shape);
    void compare_sparse_query(std::uint64_t shape);
    template <class Query, class Matches> void compare_changes(const Query& query, Matches matches);
    template <class Query, class Matches> void compare_query(const Query& query, Matches matches);

    std::mt19937_64 random_;
    std::size_t most_;
    World world_;
    WorldModel model_;
    std::vector<Entity> known_;
};

} // namespace hachure::test::model
