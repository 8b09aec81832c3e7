#include <hachure/runtime/app/input.h>

#include <gtest/gtest.h>

namespace hachure {
namespace {

TEST(Input, KeysAreHeldUntilTheyGoUp) {
    Input input;
    input.take(std::vector<InputEvent>{{InputKind::key_down, "space"}, {InputKind::button_down, "left"}});
    EXPECT_TRUE(input.is_down("space"));
    EXPECT_TRUE(input.was_pressed("space"));
    EXPECT_TRUE(input.buttons.contains("left"));
    input.take({});
    EXPECT_TRUE(input.is_down("space"));
    EXPECT_FALSE(input.was_pressed("space"));
    input.take(std::vector<InputEvent>{{InputKind::key_up, "space"}});
    EXPECT_FALSE(input.is_down("space"));
    EXPECT_TRUE(input.was_released("space"));
}

TEST(Input, RepeatsAreNoEvents) {
    Input input;
    const std::vector<InputEvent> down{
        {InputKind::key_down, "a"}, {InputKind::key_down, "a"}, {InputKind::key_up, "b"}};
    input.take(down);
    EXPECT_EQ(input.events.size(), 1u);
    input.take(down);
    EXPECT_TRUE(input.events.empty());
    EXPECT_FALSE(input.was_pressed("a"));
}

TEST(Input, PointerMovementAddsUpWithinAFrame) {
    Input input;
    input.take(std::vector<InputEvent>{{InputKind::pointer_move, "", {10.0f, 5.0f}},
                                       {InputKind::pointer_move, "", {12.0f, 9.0f}},
                                       {InputKind::scroll, "", {0.0f, 1.0f}},
                                       {InputKind::scroll, "", {0.0f, 2.0f}}});
    EXPECT_EQ(input.pointer, glm::vec2(12.0f, 9.0f));
    EXPECT_EQ(input.pointer_delta, glm::vec2(12.0f, 9.0f));
    EXPECT_EQ(input.scroll, glm::vec2(0.0f, 3.0f));
    input.take({});
    EXPECT_EQ(input.pointer_delta, glm::vec2(0.0f));
    EXPECT_EQ(input.scroll, glm::vec2(0.0f));
}

} // namespace
} // namespace hachure
