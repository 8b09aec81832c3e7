// Observers are told of every way in which components come and go, with the values in place.

#include <hachure/runtime/ecs/commands.h>
#include <hachure/runtime/ecs/world.h>
#include <hachure/tests/runtime/ecs/components.h>
#include <hachure/tests/runtime/ecs/sparse_components.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace hachure {
namespace {

using namespace test;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::UnorderedElementsAre;

/// C holds a text, and is kept in tables or sparse.
template <class C> class ObserversTest : public testing::Test {
protected:
    World observed;
    std::vector<std::string> heard; ///< "+text" and "-text"

    ObserversTest() {
        observed.on_add<C>([this](World& in, Entity entity) { heard.push_back("+" + in.get<C>(entity).text); });
        observed.on_remove<C>([this](World& in, Entity entity) { heard.push_back("-" + in.get<C>(entity).text); });
    }

    std::vector<std::string> take() { return std::exchange(heard, {}); }
    std::vector<std::string> take_sorted() {
        std::ranges::sort(heard);
        return take();
    }
};
using Kinds = testing::Types<Label, Note>;
TYPED_TEST_SUITE(ObserversTest, Kinds);

TYPED_TEST(ObserversTest, AddReplaceRemove) {
    using C = TypeParam;
    World& world = this->observed;
    const Entity entity = world.create();
    EXPECT_THAT(this->take(), IsEmpty());
    world.add(entity, C{"a"});
    EXPECT_THAT(this->take(), ElementsAre("+a"));
    world.add(entity, C{"b"});
    world.get_mutable<C>(entity).text = "c";
    world.add(entity, Position{});
    world.add(entity, Heat{});
    world.remove<Position>(entity);
    EXPECT_THAT(this->take(), IsEmpty());
    world.remove<C>(entity);
    EXPECT_THAT(this->take(), ElementsAre("-c"));
    EXPECT_FALSE(world.remove<C>(entity));
    EXPECT_TRUE(world.set_if_different(entity, C{"d"}));
    EXPECT_THAT(this->take(), ElementsAre("+d"));
    world.destroy(world.create_with(Position{}, Heat{}));
    EXPECT_THAT(this->take(), IsEmpty());
}

TYPED_TEST(ObserversTest, Create) {
    using C = TypeParam;
    World& world = this->observed;
    world.create_with(Position{}, C{"with"}, Heat{});
    EXPECT_THAT(this->take(), ElementsAre("+with"));
    world.create_many(3, C{"many"}, Speed{});
    EXPECT_THAT(this->take(), ElementsAre("+many", "+many", "+many"));
    world.create_each<Speed, C>(
        2, [](std::size_t i, Entity, Speed&, C& value) { value.text = "each " + std::to_string(i); });
    EXPECT_THAT(this->take(), ElementsAre("+each 0", "+each 1"));
    world.create_each<C, Heat>(2, [](std::size_t i, Entity, C& value, Heat&) { value.text = std::to_string(i); });
    EXPECT_THAT(this->take(), ElementsAre("+0", "+1"));
    world.create_many(0, C{"none"});
    EXPECT_THAT(this->take(), IsEmpty());
}

TYPED_TEST(ObserversTest, ManyChunksAtOnce) {
    this->observed.create_many(5000, TypeParam{"x"}, Position{});
    EXPECT_EQ(this->take().size(), 5000u);
    this->observed.destroy_matching(this->observed.template query<const TypeParam>());
    EXPECT_EQ(this->take().size(), 5000u);
}

TYPED_TEST(ObserversTest, Commands) {
    using C = TypeParam;
    World& world = this->observed;
    const Entity there = world.create_with(C{"there"});
    const Entity other = world.create_with(C{"other"});
    this->take();
    auto& commands = world.commands();
    const Entity made = commands.create();
    commands.add(made, C{"made"});
    commands.add(made, C{"replaced"});
    commands.remove<C>(there);
    commands.destroy(other);
    EXPECT_THAT(this->take(), IsEmpty());
    world.apply_commands();
    EXPECT_THAT(this->take(), ElementsAre("+made", "-there", "-other"));
}

TYPED_TEST(ObserversTest, DestroyWithDescendants) {
    using C = TypeParam;
    World& world = this->observed;
    const Entity root = world.create_with(C{"root"});
    const Entity child = world.create_with(C{"child"}), leaf = world.create_with(C{"leaf"});
    const Entity apart = world.create_with(C{"apart"});
    world.set_parent(child, root);
    world.set_parent(leaf, child);
    this->take();
    world.destroy(root);
    EXPECT_THAT(this->take(), UnorderedElementsAre("-root", "-child", "-leaf"));
    EXPECT_TRUE(world.alive(apart));
    EXPECT_FALSE(world.destroy(leaf));
    EXPECT_THAT(this->take(), IsEmpty());
}

TYPED_TEST(ObserversTest, DestroyMany) {
    using C = TypeParam;
    World& world = this->observed;
    const Entity a = world.create_with(C{"a"}), b = world.create_with(C{"b"}), c = world.create_with(C{"c"});
    world.set_parent(b, a);
    this->take();
    const std::vector<Entity> some{c, a, c, b, Entity::null};
    world.destroy_many(some);
    EXPECT_THAT(this->take_sorted(), ElementsAre("-a", "-b", "-c"));
    for (const char* name : {"d", "e"}) world.create_with(C{name}, Position{});
    this->take();
    world.destroy_matching(world.query<const Position>());
    EXPECT_THAT(this->take_sorted(), ElementsAre("-d", "-e"));
    world.create_with(C{"f"}, Position{});
    this->take();
    world.destroy_matching(world.query<const Position>().template changed_since<C>(0));
    EXPECT_THAT(this->take(), ElementsAre("-f"));
}

TYPED_TEST(ObserversTest, ClearAndRestore) {
    using C = TypeParam;
    World& world = this->observed;
    world.create_with(C{"a"});
    world.set_parent(world.create_with(C{"b"}, Position{}), world.create_with(C{"c"}, Heat{}));
    this->take();
    world.clear();
    EXPECT_THAT(this->take_sorted(), ElementsAre("-a", "-b", "-c"));
    world.create_with(C{"d"});
    this->take();
    world.restore_entities(world.entity_ids());
    EXPECT_THAT(this->take(), ElementsAre("-d"));
}

TYPED_TEST(ObserversTest, Instantiate) {
    using C = TypeParam;
    World& world = this->observed;
    const Entity prefab = world.create_with(C{"prefab"});
    world.set_parent(world.create_with(C{"child"}, Position{}), prefab);
    this->take();
    world.instantiate_many(prefab, 2);
    EXPECT_THAT(this->take_sorted(), ElementsAre("+child", "+child", "+prefab", "+prefab"));
}

TYPED_TEST(ObserversTest, TheEndOfTheWorldIsNotTold) {
    std::vector<std::string> told;
    {
        World world;
        world.on_remove<TypeParam>([&told](World&, Entity) { told.push_back("removed"); });
        world.create_with(TypeParam{"a"});
    }
    EXPECT_THAT(told, IsEmpty());
}

TYPED_TEST(ObserversTest, ComeLate) {
    using C = TypeParam;
    World world; // of which nobody was told so far
    const Entity entity = world.create_with(C{"early"}, Position{});
    std::vector<Entity> told;
    world.on_remove<C>([&told](World&, Entity which) { told.push_back(which); });
    const Entity other = world.create_with(C{"late"}, Speed{});
    world.destroy(entity);
    world.remove<C>(other);
    EXPECT_THAT(told, ElementsAre(entity, other));
}

TYPED_TEST(ObserversTest, MoveWithTheirWorld) {
    World moved = std::move(this->observed);
    const World* seen = nullptr;
    moved.on_add<TypeParam>([&seen](World& in, Entity) { seen = &in; });
    moved.create_with(TypeParam{"a"});
    EXPECT_EQ(seen, &moved);
    EXPECT_THAT(this->take(), ElementsAre("+a"));
}

TYPED_TEST(ObserversTest, MayReadAndWriteComponents) {
    using C = TypeParam;
    World& world = this->observed;
    world.on_add<C>([](World& in, Entity entity) {
        in.get_mutable<C>(entity).text += "!";
        if (Speed* speed = in.find_mutable<Speed>(entity)) speed->value = 9;
        for (auto [other, value] : in.query<C>()) value.text += "?";
    });
    const Entity entity = world.create_with(C{"a"}, Speed{});
    EXPECT_EQ(world.get<C>(entity).text, "a!?");
    EXPECT_EQ(world.get<Speed>(entity).value, 9);
    EXPECT_EQ(world.add(world.create(), C{"b"}).text, "b!?");
}

TYPED_TEST(ObserversTest, MayQueueCommands) {
    using C = TypeParam;
    World& world = this->observed;
    world.on_add<C>([](World& in, Entity entity) { in.commands().add(entity, Speed{5}); });
    world.on_remove<C>([](World& in, Entity entity) { in.commands().remove<Speed>(entity); });
    const Entity entity = world.create_with(C{"a"});
    EXPECT_FALSE(world.has<Speed>(entity));
    world.apply_commands();
    EXPECT_TRUE(world.has<Speed>(entity));
    world.remove<C>(entity);
    world.apply_commands();
    EXPECT_FALSE(world.has<Speed>(entity));
}

TYPED_TEST(ObserversTest, MayQueueCommandsWhileCommandsAreApplied) {
    using C = TypeParam;
    World& world = this->observed;
    world.on_add<C>([](World& in, Entity entity) {
        const Entity shadow = in.commands().create();
        in.commands().add(shadow, Position{double(in.get<C>(entity).text.size()), 0});
        in.commands().set_parent(shadow, entity);
    });
    std::vector<Entity> made;
    for (std::size_t i = 0; i < 20; ++i) {
        made.push_back(world.commands().create());
        world.commands().add(made.back(), C{std::string(i, 'x')});
    }
    world.apply_commands();
    EXPECT_TRUE(world.commands().empty());
    EXPECT_EQ(world.size(), 40u);
    for (std::size_t i = 0; i < 20; ++i) {
        EXPECT_EQ(world.get<C>(made[i]).text.size(), i);
        ASSERT_EQ(world.children(made[i]).size(), 1u);
        EXPECT_EQ(world.get<Position>(world.children(made[i])[0]).x, double(i));
    }
}

TYPED_TEST(ObserversTest, MayAddObservers) {
    using C = TypeParam;
    World& world = this->observed;
    int calls = 0;
    world.on_add<C>([&calls](World& in, Entity) {
        for (int i = 0; i < 10; ++i) in.on_add<C>([](World&, Entity) {});
        ++calls; // what the function holds is still there
    });
    world.create_with(C{"a"});
    EXPECT_EQ(calls, 1);
    world.create_with(C{"b"});
    EXPECT_EQ(calls, 2);
}

TEST(ObserversOfTheTreeTest, ParentAndChildrenComeAndGo) {
    World world;
    std::vector<std::string> told;
    const auto name = [](const char* what, Entity entity) { return what + std::to_string(entity.index); };
    world.on_add<Parent>([&](World&, Entity entity) { told.push_back(name("+parent of ", entity)); });
    world.on_remove<Parent>([&](World& in, Entity entity) {
        EXPECT_TRUE(in.parent(entity));
        told.push_back(name("-parent of ", entity));
    });
    world.on_add<Children>([&](World& in, Entity entity) {
        EXPECT_EQ(in.children(entity).size(), 1u);
        told.push_back(name("+children of ", entity));
    });
    world.on_remove<Children>([&](World&, Entity entity) { told.push_back(name("-children of ", entity)); });
    const Entity a = world.create(), b = world.create(), c = world.create();
    world.set_parent(a, b);
    EXPECT_THAT(std::exchange(told, {}), UnorderedElementsAre("+parent of 0", "+children of 1"));
    world.set_parent(c, b);
    EXPECT_THAT(std::exchange(told, {}), UnorderedElementsAre("+parent of 2"));
    world.set_parent(a, c);
    EXPECT_THAT(std::exchange(told, {}), UnorderedElementsAre("+children of 2"));
    world.clear_parent(a);
    EXPECT_THAT(std::exchange(told, {}), UnorderedElementsAre("-parent of 0", "-children of 2"));
    world.destroy(c);
    EXPECT_THAT(std::exchange(told, {}), UnorderedElementsAre("-parent of 2", "-children of 1"));
}

TEST(ObserversOfTheTreeTest, SeeTheWholeTreeThatGoes) {
    World world;
    const Entity root = world.create_with(Label{"root"});
    const Entity child = world.create_with(Label{"child"});
    const Entity leaf = world.create_with(Label{"leaf"});
    world.set_parent(child, root);
    world.set_parent(leaf, child);
    std::vector<std::string> told;
    world.on_remove<Label>([&](World& in, Entity entity) {
        const Label* above = in.find<Label>(in.parent(entity));
        told.push_back(in.get<Label>(entity).text + " under " + (above ? above->text : "nothing"));
    });
    world.instantiate(root);
    world.destroy(root);
    EXPECT_THAT(std::exchange(told, {}),
                UnorderedElementsAre("root under nothing", "child under root", "leaf under child"));
    world.clear();
    EXPECT_THAT(told, UnorderedElementsAre("root under nothing", "child under root", "leaf under child"));
}

template <class F> void while_told(F f) {
    World world;
    world.create_with(Speed{});
    world.on_add<Label>(f);
    world.create_with(Label{"a"}, Speed{});
}

TEST(ObserversDeathTest, StructuralChangesAssert) {
    const char* message = "keeps its structure";
    EXPECT_DEATH(while_told([](World& world, Entity) { world.create(); }), message);
    EXPECT_DEATH(while_told([](World& world, Entity entity) { world.destroy(entity); }), message);
    EXPECT_DEATH(while_told([](World& world, Entity entity) { world.add(entity, Position{}); }), message);
    EXPECT_DEATH(while_told([](World& world, Entity entity) { world.add(entity, Heat{}); }), message);
    EXPECT_DEATH(while_told([](World& world, Entity entity) { world.remove<Speed>(entity); }), message);
    EXPECT_DEATH(while_told([](World& world, Entity entity) { world.instantiate(entity); }), message);
    EXPECT_DEATH(while_told([](World& world, Entity) { world.clear(); }), message);
    EXPECT_DEATH(while_told([](World& world, Entity) { world.create_many(2, Speed{}); }), message);
    EXPECT_DEATH(while_told([](World& world, Entity) { world.destroy_matching(world.query<const Speed>()); }), message);
    EXPECT_DEATH(while_told([](World& world, Entity) {
                     world.commands().create();
                     world.apply_commands();
                 }),
                 message);
}

} // namespace
} // namespace hachure
