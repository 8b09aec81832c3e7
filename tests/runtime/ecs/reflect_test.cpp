#include <hachure/runtime/ecs/reflect.h>
#include <hachure/runtime/error.h>
#include <hachure/tests/runtime/ecs/reflected.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <map>
#include <string>
#include <utility>

namespace hachure {
namespace {

using namespace test;
using testing::ElementsAre;
using testing::StrEq;
using testing::ThrowsMessage;

class ReflectTest : public testing::Test {
protected:
    TypeRegistry registry;
    const TypeInfo& type = registry.add<Everything>();
    Everything value;

    const FieldInfo& field(const char* name) const {
        const FieldInfo* found = type.field(name);
        if (!found) throw std::logic_error(name);
        return *found;
    }
};

TEST_F(ReflectTest, KnowsATypeByTheHashOfItsName) {
    // The vectors that the authors of FNV publish.
    static_assert(type_hash("") == 0xcbf29ce484222325u);
    static_assert(type_hash("a") == 0xaf63dc4c8601ec8cu);
    static_assert(type_hash("foobar") == 0x85944171f73967e8u);
    EXPECT_EQ(type_hash("\xff"), 0xaf64724c8602eb6eu) << "bytes are unsigned";
    EXPECT_EQ(type.id, type_hash("everything"));
    EXPECT_EQ(type.size, sizeof(Everything));
}

TEST_F(ReflectTest, KnowsWhereMembersLie) {
    for (const FieldInfo& info : type.fields) EXPECT_LE(info.offset + info.size, type.size) << info.name;
    const auto* bytes = reinterpret_cast<const std::byte*>(&value);
    EXPECT_EQ(bytes + field("ratio").offset, reinterpret_cast<const std::byte*>(&value.ratio));
    EXPECT_EQ(bytes + field("lens").offset, reinterpret_cast<const std::byte*>(&value.lens));
    EXPECT_EQ(field("lens").size, sizeof(Lens));
}

TEST_F(ReflectTest, ReachesManyComponentsAtOnce) {
    World world;
    const std::vector<Entity> entities = world.create_many(5000);
    world.advance_tick();
    type.add_many(
        world, entities,
        [](void* context, std::size_t first, std::size_t count, void* components) {
            const auto& info = *static_cast<const TypeInfo*>(context);
            for (std::size_t i = 0; i < count; ++i) {
                auto* component = reinterpret_cast<Everything*>(static_cast<std::byte*>(components) + i * info.size);
                EXPECT_EQ(component->title, "untitled");
                component->big = static_cast<std::int64_t>(first + i);
                component->title = "t";
            }
        },
        const_cast<TypeInfo*>(&type));
    for (std::size_t i = 0; i < entities.size(); ++i)
        ASSERT_EQ(world.get<Everything>(entities[i]).big, static_cast<std::int64_t>(i));
    EXPECT_EQ(world.added_tick<Everything>(entities[4999]), 2u);
    std::vector<Entity> visited;
    type.each(
        world,
        [](void* context, Entity entity, const void* component) {
            EXPECT_EQ(static_cast<const Everything*>(component)->title, "t");
            static_cast<std::vector<Entity>*>(context)->push_back(entity);
        },
        &visited);
    std::ranges::sort(visited);
    EXPECT_EQ(visited, entities);
}

TEST_F(ReflectTest, RegistersInOrderAndOnce) {
    registry.add<Marker>();
    EXPECT_EQ(&registry.add<Everything>(), &type);
    ASSERT_EQ(registry.types().size(), 2u);
    EXPECT_EQ(registry.types()[0].name, "everything");
    EXPECT_EQ(registry.types()[1].name, "marker");
    EXPECT_EQ(registry.find("everything"), &type);
    EXPECT_EQ(registry.find("nothing"), nullptr);
    EXPECT_TRUE(registry.find("marker")->fields.empty());
}

TEST_F(ReflectTest, DescribesFields) {
    EXPECT_EQ(type.doc, "One of each.");
    EXPECT_EQ(type.field("none"), nullptr);
    const FieldInfo& ratio = field("ratio");
    EXPECT_EQ(ratio.path, "everything.ratio");
    EXPECT_EQ(ratio.doc, "a share");
    EXPECT_EQ(ratio.unit, "m");
    ASSERT_TRUE(ratio.range);
    EXPECT_EQ(ratio.range->min, 0);
    EXPECT_EQ(ratio.range->max, 0.1);
    EXPECT_FALSE(field("plane").range);
    EXPECT_THAT(field("lens").options, ElementsAre("perspective", "orthographic", "fisheye"));
}

TEST_F(ReflectTest, KnowsKinds) {
    const std::map<std::string, FieldKind> kinds{
        {"on", FieldKind::boolean},    {"small", FieldKind::integer},       {"count", FieldKind::integer},
        {"big", FieldKind::integer},   {"seed", FieldKind::integer},        {"ratio", FieldKind::real},
        {"exact", FieldKind::real},    {"offset", FieldKind::vec2},         {"direction", FieldKind::vec3},
        {"plane", FieldKind::vec4},    {"rotation", FieldKind::quaternion}, {"paint", FieldKind::color},
        {"glaze", FieldKind::color},   {"title", FieldKind::text},          {"lens", FieldKind::enumeration},
        {"target", FieldKind::entity},
    };
    ASSERT_EQ(kinds.size(), type.fields.size());
    for (const FieldInfo& info : type.fields) EXPECT_EQ(info.kind, kinds.at(info.name)) << info.name;
    EXPECT_EQ(to_string(FieldKind::boolean), "boolean");
    EXPECT_EQ(to_string(FieldKind::enumeration), "enumeration");
}

TEST_F(ReflectTest, ReadsDefaults) {
    EXPECT_EQ(field("on").default_value, FieldValue(true));
    EXPECT_EQ(field("small").default_value, FieldValue(std::int64_t{-3}));
    EXPECT_EQ(field("seed").default_value, FieldValue(std::numeric_limits<std::uint64_t>::max()));
    EXPECT_EQ(field("ratio").default_value, FieldValue(double{0.1f}));
    EXPECT_EQ(field("offset").default_value, FieldValue(glm::vec2(1, 2)));
    EXPECT_EQ(field("rotation").default_value, FieldValue(glm::quat(1, 0, 0, 0)));
    EXPECT_EQ(field("title").default_value, FieldValue(std::string("untitled")));
    EXPECT_EQ(field("lens").default_value, FieldValue(std::string("orthographic")));
}

TEST_F(ReflectTest, WritesFields) {
    field("small").set(&value, std::int64_t{7});
    field("ratio").set(&value, 0.05);
    field("paint").set(&value, glm::vec3(0.25f));
    field("title").set(&value, std::string("a \"title\""));
    field("lens").set(&value, std::string("fisheye"));
    EXPECT_EQ(value.small, 7);
    EXPECT_EQ(value.ratio, 0.05f);
    EXPECT_EQ(value.paint, glm::vec3(0.25f));
    EXPECT_EQ(value.title, "a \"title\"");
    EXPECT_EQ(value.lens, Lens::fisheye);
    EXPECT_EQ(field("lens").get(&value), FieldValue(std::string("fisheye")));
    field("target").set(&value, Entity{3, 1});
    EXPECT_EQ(value.target, (Entity{3, 1}));
}

TEST_F(ReflectTest, RefusesFaultyValues) {
    const auto refused = [&](const char* name, FieldValue wrong, const char* message) {
        const FieldInfo& info = field(name);
        const FieldValue before = info.get(&value);
        EXPECT_THAT([&] { info.set(&value, wrong); }, ThrowsMessage<Error>(StrEq(message)));
        EXPECT_EQ(info.get(&value), before);
    };
    const double infinity = std::numeric_limits<double>::infinity();
    const float nan = std::numeric_limits<float>::quiet_NaN();
    refused("small", std::int64_t{11}, "everything.small: 11 is outside [-10, 10]");
    refused("small", 1.0, "everything.small: the value is no integer");
    refused("count", std::uint64_t{1} << 32, "everything.count: 4294967296 does not fit in 32 bits");
    refused("ratio", 0.2, "everything.ratio: 0.2 is outside [0, 0.1]");
    refused("ratio", infinity, "everything.ratio: the number is not finite");
    refused("exact", 0.0999, "everything.exact: 0.0999 is outside [0.1, 1]");
    refused("plane", glm::vec4(0, nan, 0, 0), "everything.plane: the number is not finite");
    refused("direction", glm::vec3(0, 0, -1.5f), "everything.direction: -1.5 is outside [-1, 1]");
    refused("direction", glm::vec2(0), "everything.direction: the value is no vec3");
    refused("rotation", glm::quat(0, 0, 0, 0), "everything.rotation: a rotation is a quaternion of length 1");
    refused("rotation", glm::quat(nan, 0, 0, 0), "everything.rotation: the number is not finite");
    refused("target", Entity{3, 0}, "everything.target: 3v0 is no handle of a world");
    refused("target", std::string("3v1"), "everything.target: the value is no entity");
    refused("lens", std::string("mirror"), "everything.lens: \"mirror\" is none of perspective, orthographic, fisheye");
    EXPECT_EQ(field("ratio").fault(double{0.1f}), "") << "a bound is allowed in single precision too";
}

TEST_F(ReflectTest, ReachesComponentsOfAWorld) {
    World world;
    const Entity entity = world.create();
    const Entity other = world.create();
    EXPECT_EQ(type.find(world, entity), nullptr);
    void* added = type.add_default(world, entity);
    EXPECT_EQ(added, world.find<Everything>(entity));
    world.advance_tick();
    field("small").set(type.find_mutable(world, entity), std::int64_t{9});
    EXPECT_EQ(world.get<Everything>(entity).small, 9);
    EXPECT_EQ(world.changed_tick<Everything>(entity), 2u);
    EXPECT_EQ(field("small").get(type.find(world, entity)), FieldValue(std::int64_t{9}));
    EXPECT_THAT(type.entities(world), ElementsAre(entity));
    EXPECT_TRUE(type.remove(world, entity));
    EXPECT_FALSE(type.remove(world, other));
    EXPECT_THAT(type.entities(world), ElementsAre());
    EXPECT_THROW(type.add_default(world, Entity::null), DeadEntity);
}

struct Nameless {};
void reflect(TypeBuilder<Nameless>&) {}
struct Impostor {};
void reflect(TypeBuilder<Impostor>& type) { type.name("everything"); }
struct OutOfRange {
    float x = 2;
};
void reflect(TypeBuilder<OutOfRange>& type) { type.name("out").field("x", &OutOfRange::x).range(0, 1); }
struct NoOptions {
    Lens lens = Lens::perspective;
};
void reflect(TypeBuilder<NoOptions>& type) { type.name("none").field("lens", &NoOptions::lens); }
struct Twice {
    float x = 2;
};
void reflect(TypeBuilder<Twice>& type) {
    type.name("twice");
    type.field("x", &Twice::x);
    type.field("x", &Twice::x);
}

TEST(ReflectDeathTest, OurOwnMistakesAssert) {
    TypeRegistry registry;
    registry.add<Everything>();
    EXPECT_DEATH(registry.add<Nameless>(), "has a name");
    EXPECT_DEATH(registry.add<Impostor>(), "name is its own");
    EXPECT_DEATH(registry.add<OutOfRange>(), "within its own range");
    EXPECT_DEATH(registry.add<NoOptions>(), "has options");
    EXPECT_DEATH(registry.add<Twice>(), "name is its own");
}

} // namespace
} // namespace hachure
