// Ten thousand entities, of which a timeline with a thousand tracks moves a thousand: what the timeline system takes of
// a frame, alone and while a hundred entities a frame come and go. Then the same with a hundred times as many keys, and
// paused.

#include <hachure/components/name.h>
#include <hachure/components/timeline.h>
#include <hachure/components/transform.h>
#include <hachure/runtime/app/app.h>
#include <hachure/runtime/assets/json_text.h>
#include <hachure/runtime/scene/scene_parts.h>
#include <hachure/systems/timeline/timeline.h>
#include <hachure/systems/transform/transform.h>
#include <hachure/tests/benchmarks/bench_report.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <deque>
#include <string>
#include <vector>

namespace {

using namespace hachure;

constexpr double limit_ms = 2.0;

/// Every third track is linear, cubic, or turns.
nlohmann::json timeline_of(int tracks, int keys) {
    nlohmann::json list = nlohmann::json::array();
    for (int i = 0; i < tracks; ++i) {
        nlohmann::json row = nlohmann::json::array();
        for (int k = 0; k < keys; ++k) {
            const double time = 100.0 * k / keys, angle = 0.3 * k + i;
            row.push_back({time, i % 3 == 2 ? nlohmann::json{0.0, std::sin(angle), 0.0, std::cos(angle)}
                                            : nlohmann::json{std::sin(angle), std::cos(angle), 0.1 * i}});
        }
        list.push_back({{"target", fmt::format("thing {}/transform.{}", i, i % 3 == 2 ? "rotation" : "translation")},
                        {"interpolation", i % 3 == 1 ? "cubic" : "linear"},
                        {"keys", row}});
    }
    return {{"repeat", "loop"}, {"tracks", list}};
}

/// A world with a timeline.
class Show {
public:
    Show(int entities, int tracks, int keys) {
        app_.add_component<Name>();
        register_transform(app_);
        register_timeline(app_);
        World& world = app_.world();
        for (int i = 0; i < entities; ++i) world.create_with(Name{fmt::format("thing {}", i)}, Transform{});
        director_ = world.create();
        const assets::JsonText text = assets::JsonText::parse("bench", timeline_of(tracks, keys).dump());
        std::vector<std::string> warnings;
        const double start = bench::now_ms();
        world.resource<SceneParts>()
            .find("timeline")
            ->read(world, director_, {text, "", text.root(), app_.types(), {}, warnings});
        read_ms = bench::now_ms() - start;
    }

    /// The best of many frames, and the middle one.
    void measure(int frames, int come_and_go, const char* name = "guest") {
        std::vector<double> all;
        for (int i = 0; i < frames; ++i) {
            exchange(come_and_go, name);
            app_.run_frame(1.0 / 60.0);
            for (const SystemTime& time : app_.schedule().times())
                if (time.name == "timeline") all.push_back(time.ms);
        }
        best = *std::ranges::min_element(all);
        middle = bench::median(all);
    }

    void pause() { app_.world().get_mutable<Timeline>(director_).playing = false; }
    std::uint64_t tracks() { return app_.world().resource<TimelineCounts>().tracks; }

    double read_ms = 0.0, best = 0.0, middle = 0.0;

private:
    void exchange(int count, const char* name) {
        World& world = app_.world();
        for (int i = 0; i < count; ++i) {
            const Entity guest = world.create_with(Name{fmt::format("{} {}", name, i)}, Transform{});
            world.set_parent(guest, director_);
            guests_.push_back(guest);
        }
        while (guests_.size() > 10u * static_cast<std::size_t>(count)) {
            world.destroy(guests_.front());
            guests_.pop_front();
        }
    }

    App app_;
    Entity director_;
    std::deque<Entity> guests_;
};

} // namespace

int main(int argc, char** argv) {
    const bench::Arguments arguments =
        bench::parse_arguments(argc, argv, "A timeline with a thousand tracks among ten thousand entities");
    const int entities = arguments.quick ? 200 : 10'000, tracks = arguments.quick ? 20 : 1'000;
    const int frames = arguments.quick ? 3 : 300, guests = arguments.quick ? 5 : 100;
    const std::string who = fmt::format("{} tracks, {} entities: ", tracks, entities);
    bench::Report report(arguments);
    Show show(entities, tracks, 20);
    show.measure(frames, 0);
    report.add(who + "best frame", show.best, "ms");
    report.add_limited(who + "frame", show.middle, "ms", limit_ms);
    report.add(who + "tracks sampled", static_cast<double>(show.tracks()), "");
    const double still = show.best;
    show.measure(frames, guests);
    report.add_limited(who + fmt::format("frame while {} come and go", guests), show.middle, "ms", limit_ms);
    show.measure(frames, guests, "thing");
    report.add_limited(who + "the same, with names of targets", show.middle, "ms", limit_ms);
    show.pause();
    show.measure(arguments.quick ? 3 : 50, 0);
    report.add(who + "frame when paused", show.middle, "ms");
    report.add_limited(who + "tracks sampled when paused", static_cast<double>(show.tracks()), "", 0.0);
    Show longer(entities, tracks, arguments.quick ? 40 : 2'000);
    longer.measure(frames, 0);
    report.add(who + "reading 100 times the keys", longer.read_ms, "ms");
    report.add(who + "frame with 100 times the keys", longer.middle, "ms");
    report.add_limited(who + "100 times the keys, how many times as long", longer.best / still, "", 2.0);
    return report.finish();
}
