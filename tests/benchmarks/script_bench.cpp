// A frame of scripts: of ten thousand entities a hundred turn themselves by a script each, and one script walks all of
// them and adds up a field. Beside it what the same work takes in C++, and what a frame costs that has no scripts.

#include <hachure/components/gooch.h>
#include <hachure/components/name.h>
#include <hachure/components/script.h>
#include <hachure/components/transform.h>
#include <hachure/runtime/app/app.h>
#include <hachure/systems/script/script.h>
#include <hachure/systems/script/script_errors.h>
#include <hachure/tests/benchmarks/bench_report.h>
#include <hachure/tests/support/temp_folder.h>

#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

namespace {

using namespace hachure;

constexpr double limit_ms = 2.0;

constexpr const char* turning = R"(
local axis = vec3(0, 1, 0)
function update(dt)
    self.transform.rotation = quat.axis_angle(axis, time.seconds)
end)";

constexpr const char* summing = R"(
function update(dt)
    local sum = 0
    for e, gooch in scene.query("gooch") do sum = sum + gooch.b end
    self.transform.translation = vec3(sum, 0, 0)
end)";

constexpr const char* summing_by_entity = R"(
function update(dt)
    local sum = 0
    for e in scene.query("gooch") do sum = sum + e.gooch.b end
    self.transform.translation = vec3(sum, 0, 0)
end)";

/// The best of so many frames, in milliseconds, of an app with `count` entities, `turners` of which have a script, and
/// one more script that looks at all.
double frame_ms(int count, int turners, const char* looker, int frames) {
    const test::TempFolder folder;
    App app;
    register_script(app);
    app.add_component<Name>();
    app.add_component<Transform>();
    app.add_component<Gooch>();
    World& world = app.world();
    const std::vector<Entity> all = world.create_many(static_cast<std::size_t>(count), Transform{}, Gooch{});
    const std::string turn = folder.write("turn.lua", turning).string();
    for (int i = 0; i < turners; ++i) world.add(all[static_cast<std::size_t>(i * count / turners)], Script{turn});
    if (looker) world.create_with(Transform{}, Script{folder.write("look.lua", looker).string()});
    double best = 1e9;
    for (int i = 0; i < frames; ++i) {
        const double begin = bench::now_ms();
        app.run_frame(1.0 / 60);
        if (i > 0) best = std::min(best, bench::now_ms() - begin); // the first compiles
    }
    for (const ScriptError& error : world.resource<ScriptErrors>().errors)
        std::fprintf(stderr, "%s\n", error.message.c_str());
    if (!world.resource<ScriptErrors>().errors.empty()) std::exit(1);
    return best;
}

/// The same work without scripts.
double native_ms(int count, int turners, int frames) {
    World world;
    const std::vector<Entity> all = world.create_many(static_cast<std::size_t>(count), Transform{}, Gooch{});
    double best = 1e9;
    float total = 0;
    for (int frame = 0; frame < frames; ++frame) {
        const double begin = bench::now_ms();
        for (int i = 0; i < turners; ++i)
            world.get_mutable<Transform>(all[static_cast<std::size_t>(i * count / turners)]).rotation =
                glm::angleAxis(static_cast<float>(frame), glm::vec3(0, 1, 0));
        world.query<const Gooch>().each([&total](const Gooch& gooch) { total += gooch.b; });
        best = std::min(best, bench::now_ms() - begin);
    }
    if (total < 0) std::abort();
    return best;
}

} // namespace

int main(int argc, char** argv) {
    const auto arguments = bench::parse_arguments(argc, argv, "scripts of entities");
    const int count = arguments.quick ? 500 : 10'000, turners = arguments.quick ? 10 : 100;
    const int frames = arguments.quick ? 3 : 300;
    const double both = frame_ms(count, turners, summing, frames);
    bench::Report report(arguments);
    report.add("entities", count, "");
    report.add("scripts", turners + 1, "");
    report.add("one walk over all", frame_ms(count, 0, summing, frames), "ms");
    report.add("one walk, component by entity", frame_ms(count, 0, summing_by_entity, frames), "ms");
    report.add("scripts that turn", frame_ms(count, turners, nullptr, frames), "ms");
    report.add("a frame without scripts", frame_ms(count, 0, nullptr, frames), "ms");
    report.add("the same in C++", native_ms(count, turners, frames), "ms");
    report.add_limited("a frame of scripts", both, "ms", limit_ms);
    return report.finish();
}
