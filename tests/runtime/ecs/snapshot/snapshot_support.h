#pragma once

#include <hachure/runtime/ecs/snapshot.h>
#include <hachure/tests/runtime/ecs/reflected.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <map>
#include <random>
#include <string>
#include <vector>

/// What tests of snapshots share: worlds with a bit of everything, and a look at all of a world that does not go
/// through snapshots.
namespace hachure::test {

using Snapshot = std::vector<std::byte>;

/// Refers to another entity.
struct Link {
    Entity target;
    std::string note;
    std::int32_t weight = 7;
};

inline void reflect(TypeBuilder<Link>& type) {
    type.name("link").doc("Refers to another entity.");
    type.field("target", &Link::target);
    type.field("note", &Link::note);
    type.field("weight", &Link::weight).range(-100, 100);
}

/// Enumerators smaller than an int, and a member that is not reflected.
enum class Shade : std::uint8_t { dark, light };

struct Tone {
    Shade shade = Shade::light;
    float level = 0.5f;
    int cached = -1;
};

inline void reflect(TypeBuilder<Tone>& type) {
    type.name("tone").doc("A tone.");
    type.field("shade", &Tone::shade).options({"dark", "light"});
    type.field("level", &Tone::level).range(0, 1);
}

inline TypeRegistry all_types() {
    TypeRegistry types;
    types.add<Everything>();
    types.add<Marker>();
    types.add<Link>();
    types.add<Tone>();
    return types;
}

/// Fills worlds with whatever a world can hold.
class RandomWorld {
public:
    explicit RandomWorld(std::uint64_t seed) : random_(seed) {}

    World make(std::size_t steps) {
        World world;
        for (std::size_t i = 0; i < steps; ++i) step(world);
        return world;
    }

private:
    std::uint64_t pick(std::uint64_t n) { return random_() % n; }
    float real(float min, float max) { return std::uniform_real_distribution<float>(min, max)(random_); }
    Entity any() { return known_.empty() ? Entity::null : known_[pick(known_.size())]; }

    void step(World& world) {
        const Entity entity = any();
        const auto dice = pick(100);
        if (dice < 40 || !world.alive(entity)) return known_.push_back(world.create());
        if (dice < 46) return static_cast<void>(world.destroy(entity));
        if (dice < 60) return set_parent(world, entity, any());
        if (dice < 64) return world.clear_parent(entity);
        if (dice < 78) return static_cast<void>(world.add(entity, everything()));
        if (dice < 84) return static_cast<void>(world.add(entity, Marker{}));
        if (dice < 92)
            return static_cast<void>(world.add(entity, Link{any(), text(), static_cast<std::int32_t>(pick(9))}));
        if (dice < 97) return static_cast<void>(world.add(entity, Tone{Shade{static_cast<std::uint8_t>(pick(2))}}));
        world.remove<Everything>(entity);
    }

    void set_parent(World& world, Entity child, Entity parent) {
        for (Entity above = parent; above; above = world.parent(above))
            if (above == child) return;
        if (world.alive(parent)) world.set_parent(child, parent);
    }

    std::string text() { return std::string(pick(20), static_cast<char>('a' + pick(26))); }

    Everything everything() {
        Everything value;
        const auto maybe = [this] { return pick(3) == 0; };
        if (maybe()) value.on = false;
        if (maybe()) value.small = static_cast<std::int32_t>(pick(21)) - 10;
        if (maybe()) value.count = static_cast<std::uint32_t>(random_());
        if (maybe()) value.big = static_cast<std::int64_t>(random_());
        if (maybe()) value.seed = random_();
        if (maybe()) value.ratio = real(0, 0.1f);
        if (maybe()) value.exact = std::uniform_real_distribution<double>(0.1, 1)(random_);
        if (maybe()) value.offset = {real(-1e30f, 1e30f), -0.0f};
        if (maybe()) value.direction = {real(-1, 1), real(-1, 1), real(-1, 1)};
        if (maybe()) value.plane = {1e-42f, real(-1, 1), 0, 2};
        if (maybe()) value.rotation = glm::quat(0.8f, 0, 0.6f, 0);
        if (maybe()) value.paint = glm::vec3(real(0, 1));
        if (maybe()) value.glaze = glm::vec4(real(0, 1));
        if (maybe()) value.title = text();
        if (maybe()) value.lens = static_cast<Lens>(pick(3));
        if (maybe()) value.target = any();
        return value;
    }

    std::mt19937_64 random_;
    std::vector<Entity> known_;
};

/// All that a snapshot holds of a world, as text.
inline std::map<std::string, std::string> look(const World& world, const TypeRegistry& types) {
    std::map<std::string, std::string> result;
    const EntityIds ids = world.entity_ids();
    for (std::size_t slot = 0; slot < ids.generations.size(); ++slot) {
        const Entity entity{static_cast<std::uint32_t>(slot), ids.generations[slot]};
        const std::string name = to_string(entity);
        if (!world.alive(entity)) continue;
        result[name] = "below " + to_string(world.parent(entity)) + " above";
        for (const Entity child : world.children(entity)) result[name] += ' ' + to_string(child);
        for (const TypeInfo& type : types.types()) {
            const void* component = type.find(world, entity);
            if (!component) continue;
            result[name + ' ' + type.name] = "there";
            for (const FieldInfo& field : type.fields)
                result[name + ' ' + field.path] = format_field(field, field.get(component));
        }
    }
    for (const std::uint32_t slot : ids.free) result["free slots"] += std::to_string(slot) + ' ';
    for (const std::uint32_t generation : ids.generations) result["generations"] += std::to_string(generation) + ' ';
    return result;
}

/// Writes length and checksum anew, as one who wants to be believed would.
void seal(Snapshot& snapshot);

/// The message of the Error that restoring throws; fails the test when none comes or the world changed. Empty when it
/// was restored and `may_succeed`.
std::string restore_fault(World& world, const TypeRegistry& types, const Snapshot& snapshot, bool may_succeed = false);

} // namespace hachure::test
