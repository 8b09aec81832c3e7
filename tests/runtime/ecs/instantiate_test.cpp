#include <hachure/runtime/ecs/world.h>
#include <hachure/tests/runtime/ecs/components.h>
#include <hachure/tests/runtime/ecs/sparse_components.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

namespace hachure {
namespace {

using namespace test;
using testing::ElementsAre;

/// Refers to others.
struct Follow {
    std::vector<Entity> targets;
};
void remap_entities(Follow& follow, const EntityMap& copies) {
    for (Entity& target : follow.targets) target = copies(target);
}

/// The same, kept sparse.
struct Aim {
    static constexpr auto storage = Storage::sparse;
    Entity target;
};
void remap_entities(Aim& aim, const EntityMap& copies) { aim.target = copies(aim.target); }

/// Refers to others and does not say so.
struct Stubborn {
    Entity target;
};

/// Can only be moved, kept sparse.
struct Lock {
    static constexpr auto storage = Storage::sparse;
    std::unique_ptr<int> value;
};

/// The texts of a tree, depth first: "root(child(leaf)other)".
std::string shape(const World& world, Entity root) {
    std::string result = world.get<Label>(root).text;
    if (world.children(root).empty()) return result;
    result += '(';
    for (const Entity child : world.children(root)) {
        EXPECT_EQ(world.parent(child), root);
        result += shape(world, child);
    }
    return result + ')';
}

class InstantiateTest : public testing::Test {
protected:
    World world;

    Entity make(const char* name, Entity parent = Entity::null) {
        const Entity entity = world.create_with(Label{name});
        if (parent) world.set_parent(entity, parent);
        return entity;
    }
};

TEST_F(InstantiateTest, CopiesTheTree) {
    const Entity root = make("r");
    const Entity a = make("a", root), b = make("b", root);
    make("c", root);
    make("d", b);
    make("e", a);
    make("f", b);
    world.add(b, Position{1, 2});
    const Entity copy = world.instantiate(root);
    EXPECT_NE(copy, root);
    EXPECT_EQ(world.size(), 14u);
    EXPECT_EQ(shape(world, copy), "r(a(e)b(df)c)");
    EXPECT_EQ(shape(world, root), "r(a(e)b(df)c)");
    EXPECT_EQ(world.get<Position>(world.children(copy)[1]), (Position{1, 2}));
    for (const Entity entity : world.descendants(copy))
        for (const Entity original : world.descendants(root)) EXPECT_NE(entity, original);
    world.destroy(root);
    EXPECT_EQ(shape(world, copy), "r(a(e)b(df)c)") << "nothing is shared";
}

TEST_F(InstantiateTest, TheCopyIsARoot) {
    const Entity root = make("r");
    const Entity branch = make("b", root);
    make("l", branch);
    const Entity copy = world.instantiate(branch);
    EXPECT_EQ(world.parent(copy), Entity::null);
    EXPECT_FALSE(world.has<Parent>(copy));
    EXPECT_THAT(world.children(root), ElementsAre(branch));
    EXPECT_EQ(shape(world, copy), "b(l)");
    const Entity leaf = world.instantiate(world.children(branch)[0]);
    EXPECT_FALSE(world.has<Parent>(leaf) || world.has<Children>(leaf));
}

TEST_F(InstantiateTest, ReferencesFollowToTheCopies) {
    const Entity outside = make("outside");
    const Entity root = make("r");
    const Entity child = make("c", root);
    world.add(root, Follow{{child, outside, root, Entity::null}});
    world.add(child, Aim{root});
    world.add(root, Aim{outside});
    world.add(root, Stubborn{child});
    const auto copies = world.instantiate_many(root, 2);
    for (const Entity copy : copies) {
        const Entity copied_child = world.children(copy)[0];
        EXPECT_THAT(world.get<Follow>(copy).targets, ElementsAre(copied_child, outside, copy, Entity::null));
        EXPECT_EQ(world.get<Aim>(copied_child).target, copy);
        EXPECT_EQ(world.get<Aim>(copy).target, outside);
        EXPECT_EQ(world.get<Stubborn>(copy).target, child);
    }
    EXPECT_THAT(world.get<Follow>(root).targets, ElementsAre(child, outside, root, Entity::null));
    EXPECT_EQ(world.get<Aim>(child).target, root);
}

TEST_F(InstantiateTest, LeavesOutWhatCannotBeCopied) {
    const Entity root = world.create_with(Label{"r"}, Owner{std::make_unique<int>(1)}, Position{3, 4});
    const Entity child = make("c", root);
    world.add(child, Owner{});
    world.add(child, Lock{});
    world.add(child, Heat{5});
    const Entity copy = world.instantiate(root);
    EXPECT_FALSE(world.has<Owner>(copy));
    EXPECT_EQ(world.get<Position>(copy), (Position{3, 4}));
    const Entity copied_child = world.children(copy)[0];
    EXPECT_FALSE(world.has<Owner>(copied_child) || world.has<Lock>(copied_child));
    EXPECT_EQ(world.get<Heat>(copied_child).value, 5);
    EXPECT_EQ(*world.get<Owner>(root).value, 1);
    EXPECT_TRUE(world.has<Lock>(child));
    const Entity locked = world.create_with(Owner{}, Lock{});
    EXPECT_FALSE(world.has<Owner>(world.instantiate(locked)));
}

TEST_F(InstantiateTest, CopiesSparseAndEmptyComponents) {
    const Entity root = world.create_with(Label{"r"}, Hidden{}, Chosen{}, Note{"a text that is longer than short"});
    const Entity copy = world.instantiate(root);
    EXPECT_TRUE(world.has<Hidden>(copy) && world.has<Chosen>(copy));
    world.get_mutable<Note>(root).text += "!";
    EXPECT_EQ(world.get<Note>(copy).text, "a text that is longer than short");
    EXPECT_EQ(world.query<const Chosen>().count(), 2u);
    const Entity bare = world.instantiate(world.create());
    EXPECT_TRUE(world.alive(bare));
}

TEST_F(InstantiateTest, CopiesAreNew) {
    const Entity root = world.create_with(Label{"r"}, Heat{});
    make("c", root);
    world.advance_tick();
    const Entity copy = world.instantiate(root);
    const Entity child = world.children(copy)[0];
    EXPECT_EQ(world.added_tick<Label>(copy), 2u);
    EXPECT_EQ(world.changed_tick<Heat>(copy), 2u);
    EXPECT_EQ(world.added_tick<Parent>(child), 2u);
    EXPECT_EQ(world.changed_tick<Label>(root), 1u);
    for (const auto how : {detail::ChangeWalk::queue, detail::ChangeWalk::sweep}) {
        std::vector<Entity> added;
        world.query<const Label>().added_since<Label>(1).finding_changes(how).each(
            [&](Entity entity, const Label&) { added.push_back(entity); });
        EXPECT_THAT(added, testing::UnorderedElementsAre(copy, child));
    }
}

TEST_F(InstantiateTest, MakesManyAtOnce) {
    const Entity root = world.create_with(Label{"r"}, Note{"n"});
    for (int i = 0; i < 3; ++i) make("c", root);
    const auto copies = world.instantiate_many(root, 1000);
    ASSERT_EQ(copies.size(), 1000u);
    EXPECT_EQ(world.size(), 4004u);
    for (const Entity copy : copies) ASSERT_EQ(shape(world, copy), "r(ccc)");
    EXPECT_EQ(world.query<const Note>().count(), 1001u);
    EXPECT_TRUE(world.instantiate_many(root, 0).empty());
    EXPECT_EQ(world.size(), 4004u);
}

TEST_F(InstantiateTest, CopiesOfCopies) {
    Entity root = make("r");
    for (int i = 0; i < 6; ++i) world.set_parent(world.instantiate(root), root);
    EXPECT_EQ(world.size(), 64u);
    EXPECT_EQ(world.descendants(world.instantiate(root)).size(), 63u);
    EXPECT_EQ(shape(world, world.children(root)[2]), "r(rr(r))");
}

TEST_F(InstantiateTest, ADeadPrefabThrows) {
    const Entity root = make("r");
    world.destroy(root);
    EXPECT_THROW(world.instantiate(root), DeadEntity);
    EXPECT_THROW(world.instantiate_many(root, 0), DeadEntity);
    EXPECT_THROW(world.instantiate(Entity::null), DeadEntity);
    EXPECT_EQ(world.size(), 0u);
}

TEST_F(InstantiateTest, ObserversSeeWholeCopies) {
    const Entity root = make("r");
    make("c", root);
    std::vector<std::string> told;
    world.on_add<Label>([&](World& in, Entity entity) {
        if (!in.parent(entity)) told.push_back(shape(in, entity));
    });
    world.instantiate_many(root, 2);
    EXPECT_THAT(told, ElementsAre("r(c)", "r(c)"));
}

using InstantiateDeathTest = InstantiateTest;

TEST_F(InstantiateDeathTest, NotWhileWalking) {
    const Entity root = make("r");
    EXPECT_DEATH(world.query<const Label>().each([&](const Label&) { world.instantiate(root); }),
                 "keeps its structure");
}

} // namespace
} // namespace hachure
