// Every capability of the house together: their systems are in order wherever order matters.

#include <hachure/runtime/app/app.h>
#include <hachure/systems/abstracted_lines/abstracted_lines.h>
#include <hachure/systems/animation/animation.h>
#include <hachure/systems/camera/camera.h>
#include <hachure/systems/capabilities.h>
#include <hachure/systems/compose/compose.h>
#include <hachure/systems/curvature/curvature.h>
#include <hachure/systems/deform/deform.h>
#include <hachure/systems/edge_lines/edge_lines.h>
#include <hachure/systems/gooch/gooch.h>
#include <hachure/systems/implicit_brush/implicit_brush.h>
#include <hachure/systems/light/light.h>
#include <hachure/systems/metal/metal.h>
#include <hachure/systems/paper/paper.h>
#include <hachure/systems/picture/picture.h>
#include <hachure/systems/script/script.h>
#include <hachure/systems/shade_strokes/shade_strokes.h>
#include <hachure/systems/surface/surface.h>
#include <hachure/systems/timeline/timeline.h>
#include <hachure/systems/toon/toon.h>
#include <hachure/systems/transform/transform.h>
#include <hachure/systems/velocity/velocity.h>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

namespace hachure {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// One line per pair of systems that race: which, where, and on what.
std::vector<std::string> races(App& app) {
    std::vector<std::string> result;
    for (const Ambiguity& race : app.schedule().ambiguities())
        result.push_back(fmt::format("'{}' and '{}' of stage {} race on {}: say which of them comes first", race.first,
                                     race.second, to_string(race.stage), fmt::join(race.on, ", ")));
    return result;
}

std::vector<std::string_view> names_in(App& app, Stage stage) {
    std::vector<std::string_view> result;
    for (const SystemInfo& system : app.schedule().systems())
        if (system.stage == stage) result.push_back(system.name);
    return result;
}

std::size_t place(App& app, std::string_view name) {
    const std::vector<std::string_view> names = app.schedule().names();
    return static_cast<std::size_t>(std::ranges::find(names, name) - names.begin());
}

struct Capability {
    const char* name;
    void (*add)(App&);
};
constexpr Capability capabilities[] = {
    {"transform", register_transform},
    {"camera", register_camera},
    {"light", register_light},
    {"surface", register_surface},
    {"gooch", register_gooch},
    {"edge_lines", register_edge_lines},
    {"compose", register_compose},
    {"animation", register_animation},
    {"deform", register_deform},
    {"velocity", register_velocity},
    {"curvature", register_curvature},
    {"timeline", register_timeline},
    {"script", register_script},
    {"metal", register_metal},
    {"toon", register_toon},
    {"abstracted_lines", register_abstracted_lines},
    {"picture", register_picture},
    {"paper", register_paper},
    {"implicit_brush", register_implicit_brush},
    {"shade_strokes", register_shade_strokes},
};

TEST(CapabilitiesTest, NoTwoSystemsOfAStageRace) {
    App app;
    register_capabilities(app);
    EXPECT_THAT(races(app), IsEmpty());
}

TEST(CapabilitiesTest, NorDoTheyWhereOneIsAbsent) {
    for (const Capability& absent : capabilities) {
        App app;
        for (const Capability& each : capabilities)
            if (&each != &absent) each.add(app);
        EXPECT_THAT(races(app), IsEmpty()) << "without " << absent.name;
    }
}

TEST(CapabilitiesTest, OrderIsNotThatOfRegistration) {
    App app;
    for (std::size_t i = std::size(capabilities); i-- > 0;) capabilities[i].add(app);
    EXPECT_THAT(races(app), IsEmpty());
    EXPECT_THAT(names_in(app, Stage::light), ElementsAre("camera", "light"));
    EXPECT_LT(place(app, "surface.collect"), place(app, "gooch.claim"));
    EXPECT_LT(place(app, "surface.collect"), place(app, "metal.claim"));
    EXPECT_LT(place(app, "surface.collect"), place(app, "picture.collect"));
    EXPECT_LT(place(app, "gooch.claim"), place(app, "metal.claim"));
    EXPECT_LT(place(app, "surface.collect"), place(app, "edge_lines.select"));
    EXPECT_LT(place(app, "metal.claim"), place(app, "toon.claim"));
    EXPECT_LT(place(app, "deform"), place(app, "toon.normals"));
    EXPECT_THAT(names_in(app, Stage::render),
                ElementsAre("deform.pass", "surface.passes", "picture.pass", "gooch.pass", "metal.pass", "toon.pass",
                            "edge_lines.pass", "abstracted_lines.pass", "velocity.pass", "implicit_brush.pass",
                            "shade_strokes.pass", "compose.blank", "paper.pass", "compose.passes"));
}

/// What draws talks to OpenGL, whose context belongs to one thread, and what users write may touch anything; the rest
/// says what it touches.
TEST(CapabilitiesTest, OnlyScriptsAndRenderSystemsTakeTheWholeWorld) {
    App app;
    register_capabilities(app);
    for (const SystemInfo& system : app.schedule().systems()) {
        EXPECT_EQ(system.access.exclusive, system.stage == Stage::render || system.stage == Stage::script)
            << system.name;
        EXPECT_FALSE(system.access.reads_world) << system.name;
    }
}

} // namespace
} // namespace hachure
