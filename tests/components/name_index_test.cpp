#include <hachure/components/name.h>
#include <hachure/components/name_index.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace hachure {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

class NameIndexTest : public testing::Test {
protected:
    Entity add(const std::string& name, Entity parent = Entity::null) {
        const Entity entity = world.create_with(Name{name});
        if (parent) world.set_parent(entity, parent);
        return entity;
    }

    std::vector<Entity> all(std::string_view path) {
        index.update(world);
        return index.find_all(world, path);
    }

    Entity find(std::string_view path) {
        index.update(world);
        return index.find(world, path);
    }

    World world;
    NameIndex index;
};

TEST_F(NameIndexTest, FindsByName) {
    world.create();
    const Entity car = add("car");
    const Entity bus = add("bus");
    EXPECT_EQ(find("car"), car);
    EXPECT_EQ(find("bus"), bus);
    EXPECT_EQ(find("ca"), Entity::null);
    EXPECT_EQ(find("cart"), Entity::null);
    EXPECT_EQ(find(""), Entity::null);
}

TEST_F(NameIndexTest, FindsByPath) {
    const Entity car = add("car"), bus = add("bus");
    const Entity car_wheel = add("wheel", car), bus_wheel = add("wheel", bus);
    const Entity rim = add("rim", bus_wheel);
    EXPECT_EQ(find("car/wheel"), car_wheel);
    EXPECT_EQ(find("bus/wheel"), bus_wheel);
    EXPECT_EQ(find("bus/wheel/rim"), rim);
    EXPECT_EQ(find("wheel/rim"), rim) << "a path begins anywhere";
    EXPECT_EQ(find("bus/rim"), Entity::null) << "but leaves nobody out";
    EXPECT_EQ(find("car/wheel/rim"), Entity::null);
    EXPECT_EQ(find("/wheel"), Entity::null);
    EXPECT_EQ(find("wheel/"), Entity::null);
}

TEST_F(NameIndexTest, AnUnnamedEntityEndsAPath) {
    const Entity car = add("car");
    const Entity unnamed = world.create();
    world.set_parent(unnamed, car);
    const Entity wheel = add("wheel", unnamed);
    EXPECT_EQ(find("wheel"), wheel);
    EXPECT_EQ(find("car/wheel"), Entity::null);
}

TEST_F(NameIndexTest, ASlashMayBePartOfAName) {
    const Entity odd = add("left/right");
    const Entity child = add("a/b", odd);
    const Entity left = add("left");
    const Entity right = add("right", left);
    EXPECT_THAT(all("left/right"), ElementsAre(odd, right));
    EXPECT_EQ(find("left/right/a/b"), child);
    EXPECT_EQ(find("right/a/b"), Entity::null);
}

TEST_F(NameIndexTest, RepeatedNamesComeInOrderOfTheTree) {
    const Entity first = add("x");
    const Entity second = add("x");
    const Entity late_child = add("x", second);
    const Entity b = add("x", first);
    const Entity c = add("x", first);
    const Entity below_b = add("x", b);
    EXPECT_THAT(all("x"), ElementsAre(first, b, below_b, c, second, late_child));
    EXPECT_EQ(find("x/x"), b);
    world.clear_parent(b);
    world.set_parent(b, first); // now the last of its siblings
    EXPECT_THAT(all("x"), ElementsAre(first, c, b, below_b, second, late_child));
}

TEST_F(NameIndexTest, FollowsChanges) {
    const Entity car = add("car");
    EXPECT_EQ(find("car"), car);
    world.advance_tick();
    world.get_mutable<Name>(car).text = "van";
    EXPECT_EQ(find("car"), Entity::null);
    EXPECT_EQ(find("van"), car);
    world.advance_tick();
    world.remove<Name>(car);
    EXPECT_EQ(find("van"), Entity::null);
    world.advance_tick();
    world.add(car, Name{"car"});
    EXPECT_EQ(find("car"), car);
    world.advance_tick();
    world.destroy(car);
    EXPECT_EQ(find("car"), Entity::null);
}

TEST_F(NameIndexTest, FollowsChangesWithinOneTick) {
    const Entity car = add("car");
    EXPECT_EQ(find("car"), car);
    world.get_mutable<Name>(car).text = "van";
    EXPECT_EQ(find("van"), car);
    world.remove<Name>(car);
    EXPECT_THAT(all("van"), IsEmpty());
    world.add(car, Name{"bus"});
    EXPECT_THAT(all("bus"), ElementsAre(car));
    const Entity second = add("bus");
    EXPECT_THAT(all("bus"), ElementsAre(car, second));
}

TEST_F(NameIndexTest, NeverFindsWhatIsNotThere) {
    const Entity car = add("car"), bus = add("bus"), van = add("van");
    index.update(world);
    world.advance_tick();
    world.destroy(car);
    world.get_mutable<Name>(bus).text = "tram";
    EXPECT_EQ(index.find(world, "car"), Entity::null) << "not updated, and still not wrong";
    EXPECT_EQ(index.find(world, "bus"), Entity::null);
    world.remove<Name>(van);
    world.advance_tick();
    world.forget_removed_before(world.tick()); // nobody tells the index
    EXPECT_EQ(find("van"), Entity::null);
}

TEST_F(NameIndexTest, StaysAsIfBuiltAfresh) {
    std::mt19937 random(1);
    const auto pick = [&](std::size_t n) { return random() % n; };
    std::vector<Entity> known{world.create()};
    for (int step = 0; step < 4000; ++step) {
        const Entity entity = known[pick(known.size())];
        const Entity other = known[pick(known.size())];
        const std::string name(1, static_cast<char>('a' + pick(6)));
        const std::size_t what = pick(12);
        if (what < 4) known.push_back(add(name, world.alive(entity) ? entity : Entity::null));
        if (what < 6 && world.alive(entity)) world.add(entity, Name{name});
        if (what == 6) world.remove<Name>(entity);
        if (what == 7) world.destroy(entity);
        if (what == 8) world.clear_parent(entity);
        if (what == 9 && world.alive(other) && world.parent(entity)) {
            world.clear_parent(entity);
            if (world.descendants(entity).empty() && entity != other) world.set_parent(entity, other);
        }
        if (what == 10) world.advance_tick();
        if (step % 7 != 0) continue;
        NameIndex fresh;
        fresh.update(world);
        const std::string path = name + "/" + static_cast<char>('a' + pick(6));
        ASSERT_EQ(all(name), fresh.find_all(world, name)) << step;
        ASSERT_EQ(all(path), fresh.find_all(world, path)) << step;
        const Entity root = known[pick(known.size())];
        const std::vector<Entity> below = world.descendants(root), matches = all(path);
        const auto first =
            std::ranges::find_if(matches, [&](Entity match) { return std::ranges::find(below, match) != below.end(); });
        ASSERT_EQ(index.find_below(world, root, path), first == matches.end() ? Entity::null : *first) << step;
        std::vector<Entity> carriers;
        for (auto [carrier, carried] : world.query<const Name>())
            if (carried.text == name) carriers.push_back(carrier);
        ASSERT_TRUE(std::ranges::is_permutation(all(name), carriers)) << step;
    }
}

} // namespace
} // namespace hachure
