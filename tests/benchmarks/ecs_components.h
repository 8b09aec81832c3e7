#pragma once

#include <hachure/runtime/ecs/world.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

namespace hachure::bench {

// What the benchmarks of the world put on entities: components of three floats, tags, and one that asks to be kept
// apart from the others.

struct Position {
    float x = 0.0f, y = 0.0f, z = 0.0f;
};

struct Velocity {
    float x = 0.0f, y = 0.0f, z = 0.0f;
};

struct Extra {
    float x = 0.0f, y = 0.0f, z = 0.0f;
};

struct Fourth {
    float x = 0.0f, y = 0.0f, z = 0.0f;
};

struct Fifth {
    float x = 0.0f, y = 0.0f, z = 0.0f;
};

/// As Extra, for entities that gain and lose it often.
struct SparseExtra {
    static constexpr auto storage = Storage::sparse;
    float x = 0.0f, y = 0.0f, z = 0.0f;
};

struct Tag {};

/// On no entity of any benchmark.
struct Never {
    float x = 0.0f;
};

/// The value of component C on the i-th entity: another one for each.
template <class C> C component(std::size_t i) {
    const auto value = static_cast<float>(i & 0xfffffu);
    return {value, value + 0.25f, 0.5f * value};
}

/// The step of motion that is timed on raw arrays and on worlds.
inline void move_by(Position& position, const Velocity& velocity) {
    position.x += velocity.x;
    position.y += velocity.y;
    position.z += velocity.z;
}

/// Fills `world` with `count` entities that have Position and Velocity; their handles in order of creation.
inline std::vector<Entity> fill(World& world, std::size_t count) {
    std::vector<Entity> entities;
    entities.reserve(count);
    world.create_each<Position, Velocity>(count, [&](std::size_t i, Entity entity, Position& p, Velocity& v) {
        p = component<Position>(i);
        v = component<Velocity>(i);
        entities.push_back(entity);
    });
    return entities;
}

/// The same values in an order that is random but the same each time.
template <class T> std::vector<T> shuffled(std::vector<T> values) {
    std::ranges::shuffle(values, std::mt19937(1));
    return values;
}

} // namespace hachure::bench
