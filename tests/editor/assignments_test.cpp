#include <hachure/components/name.h>
#include <hachure/components/surface.h>
#include <hachure/editor/assignments.h>
#include <hachure/runtime/error.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace hachure {
namespace {

/// Two cars with a wheel each; everything has a Surface.
class AssignmentsTest : public testing::Test {
protected:
    AssignmentsTest() {
        types.add<Name>();
        types.add<Surface>();
        world.set_parent(red_wheel, red);
        world.set_parent(blue_wheel, blue);
    }

    void apply(const std::vector<std::string>& texts) { apply_assignments(world, parse_assignments(types, texts)); }
    bool visible(Entity entity) { return world.get<Surface>(entity).visible; }

    TypeRegistry types;
    World world;
    Entity red = world.create_with(Name{"red"}, Surface{});
    Entity blue = world.create_with(Name{"blue"}, Surface{});
    Entity red_wheel = world.create_with(Name{"wheel"}, Surface{});
    Entity blue_wheel = world.create_with(Name{"wheel"}, Surface{});
};

TEST_F(AssignmentsTest, GoToAllThatCarryTheComponent) {
    apply({"surface.visible=false"});
    for (const Entity entity : {red, blue, red_wheel, blue_wheel}) EXPECT_FALSE(visible(entity));
}

TEST_F(AssignmentsTest, GoToAllOfAName) {
    apply({"wheel/surface.visible=false"});
    EXPECT_FALSE(visible(red_wheel) || visible(blue_wheel));
    EXPECT_TRUE(visible(red) && visible(blue));
}

TEST_F(AssignmentsTest, GoToAPath) {
    apply({"blue/wheel/surface.visible=false"});
    EXPECT_FALSE(visible(blue_wheel));
    EXPECT_TRUE(visible(red) && visible(blue) && visible(red_wheel));
}

TEST_F(AssignmentsTest, SeeNamesThatEarlierOnesGave) {
    apply({"blue/wheel/name.text=spare", "spare/surface.visible=false"});
    EXPECT_FALSE(visible(blue_wheel));
    EXPECT_TRUE(visible(red_wheel));
}

TEST_F(AssignmentsTest, SayWhoIsMissing) {
    EXPECT_THAT([&] { apply({"red/rim/surface.visible=false"}); },
                testing::ThrowsMessage<Error>(testing::HasSubstr("no entity called 'red/rim' carries 'surface'")));
    world.remove<Surface>(red);
    EXPECT_THROW(apply({"red/surface.visible=false"}), Error);
}

} // namespace
} // namespace hachure
