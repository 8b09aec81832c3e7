#include <hachure/editor/playback_clock.h>
#include <hachure/runtime/assert.h>
#include <hachure/runtime/ecs/time.h>
#include <hachure/runtime/error.h>

#include <algorithm>
#include <cmath>

namespace hachure {

double seek(const App& app, double seconds) {
    const Time* last = app.world().find_resource<Time>();
    const double now = last ? last->elapsed : 0.0;
    HACHURE_ASSERT(std::isfinite(seconds) && seconds >= now, "time goes forward");
    return seconds - now;
}

void check_clip(const assets::Model& model, const std::filesystem::path& file, const std::string& clip) {
    if (clip.empty() || std::ranges::find(model.animations, clip, &assets::Animation::name) != model.animations.end())
        return;
    std::string names;
    for (const assets::Animation& animation : model.animations) names += (names.empty() ? "" : ", ") + animation.name;
    throw Error(file.string(), "has no clip '" + clip + "'", names.empty() ? "it has none" : "there are " + names);
}

} // namespace hachure
