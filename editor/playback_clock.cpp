#include <hachure/editor/playback_clock.h>
#include <hachure/runtime/assert.h>
#include <hachure/runtime/ecs/time.h>

#include <cmath>

namespace hachure {

double seek(const App& app, double seconds) {
    const Time* last = app.world().find_resource<Time>();
    const double now = last ? last->elapsed : 0.0;
    HACHURE_ASSERT(std::isfinite(seconds) && seconds >= now, "time goes forward");
    return seconds - now;
}

} // namespace hachure
