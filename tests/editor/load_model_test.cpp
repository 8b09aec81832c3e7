#include <hachure/components/animation.h>
#include <hachure/editor/load_model.h>
#include <hachure/runtime/error.h>
#include <hachure/systems/capabilities.h>
#include <hachure/tests/support/arm_model.h>

#include <gtest/gtest.h>

namespace hachure::test {
namespace {

/// The clip that the model plays; "none" when it plays nothing.
std::string played(const assets::Model& model, const std::optional<std::string>& clip) {
    App app;
    register_capabilities(app);
    load_model(app, model, "arm.glb", {64, 48}, clip);
    const auto playing = app.world().query<const Animation>();
    return playing.empty() ? "none" : std::get<const Animation&>(*playing.begin()).clip;
}

TEST(LoadModel, PlaysTheClipThatIsAskedFor) {
    EXPECT_EQ(played(arm_model(), std::nullopt), "none");
    EXPECT_EQ(played(arm_model(), ""), "bend") << "the first";
    EXPECT_EQ(played(arm_model(), "walk"), "walk");
}

TEST(LoadModel, NamesTheClipsThatThereAre) {
    try {
        played(arm_model(), "fly");
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(std::string(error.what()), "arm.glb: has no clip 'fly' (there are bend, walk, swell)");
    }
    assets::Model still = arm_model();
    still.animations.clear();
    EXPECT_EQ(played(still, ""), "none");
    EXPECT_THROW(played(still, "bend"), Error);
}

} // namespace
} // namespace hachure::test
