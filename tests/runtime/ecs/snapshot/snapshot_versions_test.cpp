#include <hachure/runtime/error.h>
#include <hachure/tests/runtime/ecs/snapshot/snapshot_support.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>

/// Programs that know other components and fields than the one that saved.
namespace hachure::test {
namespace {

using testing::StrEq;

/// The program of today.
struct Brush {
    float width = 2;
    std::int32_t hairs = 5;
    std::string ink = "black";
    Lens lens = Lens::perspective;
};

void reflect(TypeBuilder<Brush>& type) {
    type.name("brush").doc("A brush.");
    type.field("width", &Brush::width).range(0, 1000);
    type.field("hairs", &Brush::hairs);
    type.field("ink", &Brush::ink);
    type.field("lens", &Brush::lens).options({"perspective", "orthographic", "fisheye"});
}

/// A program without `ink` and `lens`, and without links.
struct PlainBrush {
    float width = 2;
    std::int32_t hairs = 5;
};

void reflect(TypeBuilder<PlainBrush>& type) {
    type.name("brush").doc("A brush.");
    type.field("width", &PlainBrush::width).range(0, 1000);
    type.field("hairs", &PlainBrush::hairs);
}

/// A later program: wider numbers, another order of options, another default, and one field more.
struct LaterBrush {
    double width = 3;
    std::uint64_t hairs = 6;
    std::string ink = "blue";
    Lens lens = Lens::fisheye;
    float wetness = 0.25f;
};

void reflect(TypeBuilder<LaterBrush>& type) {
    type.name("brush").doc("A brush.");
    type.field("wetness", &LaterBrush::wetness);
    type.field("lens", &LaterBrush::lens).options({"orthographic", "fisheye", "perspective"});
    type.field("ink", &LaterBrush::ink);
    type.field("hairs", &LaterBrush::hairs);
    type.field("width", &LaterBrush::width);
}

template <class... C> TypeRegistry registry_of() {
    TypeRegistry types;
    (types.add<C>(), ...);
    return types;
}

class SnapshotVersionsTest : public testing::Test {
protected:
    SnapshotVersionsTest() {
        for (int i = 0; i < 200; ++i) {
            const Entity entity = world.create();
            if (i % 3 == 0) world.add(entity, Link{entity, i % 2 == 0 ? "even" : "", 9});
            if (i % 4 != 0) world.add(entity, Brush{1.5f, i, i % 5 == 0 ? "red" : "black", Lens{i % 3}});
            if (i % 10 == 9) world.destroy({static_cast<std::uint32_t>(i - 5), 1});
        }
        snapshot = save_snapshot(world, today);
    }

    const TypeRegistry today = registry_of<Brush, Link>();
    const TypeRegistry plain = registry_of<PlainBrush>();
    const TypeRegistry later = registry_of<LaterBrush, Link>();
    World world;
    Snapshot snapshot;
};

TEST_F(SnapshotVersionsTest, WhatAProgramDoesNotKnowGoesThroughItUnchanged) {
    World there;
    restore_snapshot(there, plain, snapshot);
    EXPECT_EQ(there.get<PlainBrush>({1, 1}).hairs, 1);
    ASSERT_TRUE(there.find_resource<UnknownComponents>());
    const Snapshot passed = save_snapshot(there, plain);
    EXPECT_EQ(passed, snapshot);
    World back;
    restore_snapshot(back, today, passed);
    EXPECT_EQ(look(back, today), look(world, today));
}

TEST_F(SnapshotVersionsTest, WhatItDoesNotKnowFollowsTheEntitiesThatItChanges) {
    World there;
    restore_snapshot(there, plain, snapshot);
    const auto in_both = [&](const std::function<void(World&)>& change) {
        change(there);
        change(world);
    };
    in_both([](World& w) { // dead entities lose it, and a slot's next entity does not inherit it
        for (std::uint32_t i = 0; i < 200; i += 7) w.destroy({i, 1});
        for (int i = 0; i < 10; ++i) w.create();
    });
    there.remove<PlainBrush>({1, 1}); // and so do entities that lose the component
    world.remove<Brush>({1, 1});
    there.get_mutable<PlainBrush>({2, 1}).hairs = 77;
    world.get_mutable<Brush>({2, 1}).hairs = 77;
    const Entity made_there = there.create_with(PlainBrush{9, 9});
    const Entity made_here = world.create_with(Brush{9, 9});
    ASSERT_EQ(made_there, made_here);
    World back;
    restore_snapshot(back, today, save_snapshot(there, plain));
    EXPECT_EQ(look(back, today), look(world, today));
}

TEST_F(SnapshotVersionsTest, FieldsOfALostComponentDoNotBringItBack) {
    World there;
    restore_snapshot(there, plain, snapshot);
    for (const Entity entity : plain.find("brush")->entities(there)) there.remove<PlainBrush>(entity);
    World back;
    restore_snapshot(back, today, save_snapshot(there, plain));
    EXPECT_TRUE(today.find("brush")->entities(back).empty());
    EXPECT_FALSE(today.find("link")->entities(back).empty());
}

TEST_F(SnapshotVersionsTest, AnotherRestoreForgetsWhatWasUnknown) {
    World there;
    restore_snapshot(there, plain, snapshot);
    restore_snapshot(there, plain, save_snapshot(World(), plain));
    EXPECT_FALSE(there.find_resource<UnknownComponents>());
}

TEST_F(SnapshotVersionsTest, ALaterProgramReadsNumbersOptionsAndDefaultsAsTheyWere) {
    World there;
    restore_snapshot(there, later, snapshot);
    std::size_t checked = 0;
    for (auto [entity, brush] : world.query<const Brush>()) {
        const LaterBrush& now = there.get<LaterBrush>(entity);
        ASSERT_EQ(now.width, 1.5);
        ASSERT_EQ(now.hairs, static_cast<std::uint64_t>(brush.hairs));
        ASSERT_EQ(now.ink, brush.ink) << "the default of then, where it was saved";
        ASSERT_EQ(later.find("brush")->field("lens")->get(&now), today.find("brush")->field("lens")->get(&brush));
        ASSERT_EQ(now.wetness, 0.25f) << "the default of now, where nothing was saved";
        ++checked;
    }
    EXPECT_GT(checked, 100u);
}

// One field, as programs of two versions have it.
template <class T, int version> struct One { T value{}; };
template <class T, int version> void reflect(TypeBuilder<One<T, version>>& type) {
    type.name("one").field("value", &One<T, version>::value);
}
struct Few {
    Lens value = Lens::perspective;
};
void reflect(TypeBuilder<Few>& type) {
    type.name("one").field("value", &Few::value).options({"perspective", "other", "x"});
}
struct Narrow {
    float value = 0;
};
void reflect(TypeBuilder<Narrow>& type) { type.name("one").field("value", &Narrow::value).range(-1, 1); }

/// What becomes of a value that was saved as `From` and is restored as `To`: its text, or the fault.
template <class From, class To> std::string passed(const From& value) {
    const TypeRegistry before = registry_of<From>(), after = registry_of<To>();
    World world;
    const Entity entity = world.create_with(From(value));
    world.create_with(From{});
    World other;
    const std::string fault = restore_fault(other, after, save_snapshot(world, before), true);
    if (!fault.empty()) return fault;
    const FieldInfo& field = *after.find("one")->field("value");
    return format_field(field, field.get(other.find<To>(entity)));
}

template <class T> using Old = One<T, 1>;
template <class T> using New = One<T, 2>;

TEST_F(SnapshotVersionsTest, NumbersAreConvertedWhereTheyFit) {
    EXPECT_EQ((passed<Old<float>, New<double>>({0.5f})), "0.5");
    EXPECT_EQ((passed<Old<double>, New<float>>({0.1})), "0.1") << "rounded";
    EXPECT_EQ((passed<Old<std::int32_t>, New<std::int64_t>>({-3})), "-3");
    EXPECT_EQ((passed<Old<std::uint64_t>, New<std::int32_t>>({12})), "12");
    EXPECT_EQ((passed<Old<float>, New<std::uint32_t>>({12})), "12");
    EXPECT_EQ((passed<Old<std::int64_t>, New<float>>({-12})), "-12");
    EXPECT_EQ((passed<Old<double>, New<std::int64_t>>({-0x1p63})), "-9223372036854775808");
    const auto unfit = [](const char* from, const char* to) {
        return std::string("snapshot: one.value: ") + from + " of the snapshot does not fit " + to + " here";
    };
    EXPECT_EQ((passed<Old<std::int32_t>, New<std::uint32_t>>({-3})), unfit("int32", "uint32"));
    EXPECT_EQ((passed<Old<float>, New<std::int32_t>>({1.5f})), unfit("float32", "int32"));
    EXPECT_EQ((passed<Old<double>, New<std::int64_t>>({0x1p63})), unfit("float64", "int64"));
    EXPECT_EQ((passed<Old<std::uint64_t>, New<std::int32_t>>({std::uint64_t{1} << 40})),
              "snapshot: one.value: 1099511627776 does not fit in 32 bits");
    EXPECT_EQ((passed<Old<double>, New<float>>({1e40})), "snapshot: one.value: 1e+40 is too large");
}

TEST_F(SnapshotVersionsTest, OtherKindsAndForbiddenValuesAreRefused) {
    EXPECT_EQ((passed<Old<std::string>, New<float>>({"1"})),
              "snapshot: one.value: is text in the snapshot and float32 here");
    EXPECT_EQ((passed<Old<bool>, New<std::int32_t>>({true})),
              "snapshot: one.value: is boolean in the snapshot and int32 here");
    EXPECT_EQ((passed<Old<glm::vec3>, New<glm::vec4>>({})),
              "snapshot: one.value: is vec3 in the snapshot and vec4 here");
    EXPECT_EQ((passed<Old<float>, Narrow>({2})), "snapshot: one.value: 2 is outside [-1, 1]");
    EXPECT_EQ((passed<Old<double>, Narrow>({2})), "snapshot: one.value: 2 is outside [-1, 1]");
    EXPECT_EQ((passed<Old<float>, Narrow>({0.5f})), "0.5");
}

struct Wordy {
    std::string value = std::string(1 << 20, 'x');
};
void reflect(TypeBuilder<Wordy>& type) { type.name("one").field("value", &Wordy::value); }

TEST_F(SnapshotVersionsTest, ALongDefaultIsNotMultipliedBeyondReason) {
    const TypeRegistry before = registry_of<Wordy>(), after = registry_of<Old<std::string>>();
    World few;
    few.create_with(Wordy{});
    const Snapshot one = save_snapshot(few, before);
    restore_snapshot(few, after, one);
    EXPECT_EQ(few.get<Old<std::string>>({0, 1}).value, Wordy{}.value);

    World wide;
    wide.create_many(1000);
    const Snapshot entities = save_snapshot(wide, before); // its frame, entities and tree, then the other's component
    World none;
    none.create();
    const std::size_t begin = save_snapshot(none, before).size() - 4;
    Snapshot bomb(entities.begin(), entities.end() - 4);
    bomb.insert(bomb.end(), one.begin() + static_cast<std::ptrdiff_t>(begin), one.end());
    seal(bomb);
    EXPECT_EQ(restore_fault(wide, after, bomb),
              "snapshot: one.value: 1000 components with 1048576 bytes of text are too many");
}

struct Three {
    Lens value = Lens::perspective;
};
void reflect(TypeBuilder<Three>& type) {
    type.name("one").field("value", &Three::value).options({"perspective", "orthographic", "x"});
}

TEST_F(SnapshotVersionsTest, OptionsAreKnownByName) {
    EXPECT_EQ((passed<Three, Few>({Lens::fisheye})), "x");
    EXPECT_EQ((passed<Three, Few>({Lens::orthographic})),
              "snapshot: one.value: \"orthographic\" is none of perspective, other, x");
}

} // namespace
} // namespace hachure::test
