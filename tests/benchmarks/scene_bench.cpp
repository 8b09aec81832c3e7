// Scene files of many entities: loading and saving, on one core, with the parsing of their JSON and the copying of
// their bytes beside them.

#include <hachure/components/animation.h>
#include <hachure/components/gooch.h>
#include <hachure/components/name.h>
#include <hachure/components/transform.h>
#include <hachure/runtime/assets/file_bytes.h>
#include <hachure/runtime/assets/json_text.h>
#include <hachure/runtime/parallel.h>
#include <hachure/systems/capabilities.h>
#include <hachure/systems/scene/load_scene.h>
#include <hachure/systems/scene/save_scene.h>
#include <hachure/tests/benchmarks/bench_report.h>
#include <hachure/tests/support/temp_folder.h>

#include <algorithm>
#include <cstdlib>
#include <functional>
#include <memory>

namespace hachure::bench {
namespace {

constexpr double limit_seconds = 2.0;

/// Groups of ten: one that others stand on, in pairs on each other; every other one has a style or a clip of its own.
void fill(World& world, std::size_t count) {
    Entity group, last;
    for (std::size_t i = 0; i < count; ++i) {
        const float x = 0.37f * static_cast<float>(i);
        const Entity entity = world.create_with(Name{"entity " + std::to_string(i)},
                                                Transform{.translation = {x, 1.0f / (1.0f + x), -x}});
        if (i % 2 == 0) world.add(entity, Gooch{.b = 0.01f * static_cast<float>(i % 100)});
        if (i % 10 == 1) world.add(entity, Animation{.clip = "Run", .offset = x});
        if (i % 10 == 0)
            group = entity;
        else
            world.set_parent(entity, i % 3 == 0 ? last : group);
        last = entity;
    }
}

std::unique_ptr<App> make_app() {
    auto app = std::make_unique<App>();
    register_capabilities(*app);
    return app;
}

/// The shortest of some runs, in seconds.
double best_of(int runs, const std::function<void()>& f) {
    double best = 1e9;
    for (int i = 0; i < runs; ++i) {
        const double begin = now_ms();
        f();
        best = std::min(best, 1e-3 * (now_ms() - begin));
    }
    return best;
}

} // namespace
} // namespace hachure::bench

int main(int argc, char** argv) {
    using namespace hachure;
    const auto arguments = bench::parse_arguments(argc, argv, "loading and saving scenes");
    const int runs = arguments.quick ? 1 : 5;
    set_thread_limit(1);
    const auto app = bench::make_app();
    bench::fill(app->world(), arguments.quick ? 1000 : 100'000);
    const test::TempFolder folder;
    const auto file = folder / "many.scene.json";

    const double save = bench::best_of(runs, [&] { write_scene(app->world(), app->types(), file); });
    std::unique_ptr<App> loaded;
    const double load = bench::best_of(runs, [&] {
        loaded = bench::make_app();
        static_cast<void>(load_scene(*loaded, file));
    });
    if (loaded->world().size() != app->world().size()) std::abort();
    const double parse = bench::best_of(runs, [&] { static_cast<void>(assets::JsonText::read(file)); });
    const double read = bench::best_of(runs, [&] { static_cast<void>(assets::read_file_bytes(file)); });

    bench::Report report(arguments);
    report.add("entities", static_cast<double>(loaded->world().size()), "");
    report.add("size", static_cast<double>(std::filesystem::file_size(file)) / 1e6, "MB");
    report.add("read the bytes", read, "s");
    report.add("parse the JSON", parse, "s");
    report.add_limited("load", load, "s", bench::limit_seconds);
    report.add_limited("save", save, "s", bench::limit_seconds);
    return report.finish();
}
