#include <hachure/components/implicit_brush.h>
#include <hachure/editor/playback_clock.h>
#include <hachure/runtime/assert.h>
#include <hachure/runtime/ecs/time.h>
#include <hachure/runtime/scene/scene_parts.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace hachure {
namespace {

/// By name: the command line works without these capabilities, too. Which strokes deliver a shade depends on how the
/// light came to need it.
constexpr std::array<std::string_view, 3> that_build_up{"script", "shade_strokes", "timeline"};

bool carried_as_component(const App& app, std::string_view name) {
    const TypeInfo* type = app.types().find(name);
    return type && !type->entities(app.world()).empty();
}

bool carried_as_part(const World& world, std::string_view name) {
    const SceneParts* parts = world.find_resource<SceneParts>();
    const ScenePart* part = parts ? parts->find(name) : nullptr;
    bool carried = false;
    if (part && part->write)
        world.query<>().each([&](Entity entity) { carried = carried || part->write(world, entity).has_value(); });
    return carried;
}

/// Noise that motion carries along remembers in which pose it was made.
bool carries_noise(const World& world) {
    bool carried = false;
    world.query<const ImplicitBrush>().each(
        [&](const ImplicitBrush& brush) { carried = carried || brush.grain == BrushGrain::advected; });
    return carried;
}

} // namespace

double seek(const App& app, double seconds) {
    const Time* last = app.world().find_resource<Time>();
    const double now = last ? last->elapsed : 0.0;
    HACHURE_ASSERT(std::isfinite(seconds) && seconds >= now, "time goes forward");
    return seconds - now;
}

bool needs_stepping(const App& app) {
    const bool builds_up = std::ranges::any_of(that_build_up, [&](std::string_view name) {
        return carried_as_component(app, name) || carried_as_part(app.world(), name);
    });
    return builds_up || carries_noise(app.world());
}

} // namespace hachure
