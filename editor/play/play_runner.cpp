#include <hachure/editor/frame_stats.h>
#include <hachure/editor/play/allocation_counter.h>
#include <hachure/editor/play/play_document.h>
#include <hachure/editor/play/play_runner.h>
#include <hachure/editor/play/played_scene.h>
#include <hachure/editor/play/shell_text.h>
#include <hachure/runtime/assets/image_file.h>
#include <hachure/runtime/error.h>
#include <hachure/runtime/picture/difference_picture.h>
#include <hachure/systems/capabilities.h>
#include <hachure/systems/script/script_errors.h>

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <set>

namespace hachure::play {
namespace {

constexpr std::int64_t strip_frames = 12;
constexpr int strip_width = 240;             // pixels
constexpr std::int64_t measured_frames = 30; // of a scene whose frames are timed
constexpr std::int64_t warm_up_frames = 2;   // of these: shaders are compiled, buffers filled

std::unique_ptr<gpu::Context> make_play_context(const PlayDocument& play, const PlayOptions& options) {
    gpu::ContextOptions wanted;
    wanted.backend = options.backend.value_or(play.backend);
    wanted.width = play.size.width;
    wanted.height = play.size.height;
    wanted.visible = false;
    wanted.vsync = false;
    std::unique_ptr<gpu::Context> context = gpu::make_context(wanted);
    const int limit = context->limits().max_texture_size;
    if (play.size.width > limit || play.size.height > limit)
        throw Error("size", fmt::format("this driver draws at most {} pixels a side", limit));
    return context;
}

/// The component types that tests may name.
const TypeRegistry& known_types() {
    static App* app = [] {
        auto* made = new App; // lives as long as the process: documents point into it
        register_capabilities(*made);
        return made;
    }();
    return app->types();
}

/// One test on its way.
class Run {
public:
    Run(const PlayDocument& play, const PlayOptions& options, PlayResult& result)
        : play_(play), options_(options), result_(result), context_(make_play_context(play, options)) {
        result.renderer = context_->description().summary();
        choose_strip();
    }

    void play() {
        const auto& all = play_.expectations;
        const bool count = std::ranges::any_of(all, [](const auto& e) { return e->counts_allocations(); });
        PlayedScene scene(*context_, play_, {}, count);
        for (const auto& expectation : all)
            if (const std::string aov = expectation->aov(); !aov.empty()) scene.renderer().request_aov(aov);
        Curve times{"frame", "ms", 0, {}, std::nullopt, std::nullopt};
        NameIndex names;
        while (scene.next_frame() < play_.frames) {
            const std::int64_t number = scene.next_frame();
            const bool draw = is_drawn(number);
            if (count) scene.renderer().finish(); // or the driver's threads would allocate meanwhile
            const FrameClock clock;
            scene.step(draw);
            if (draw) scene.renderer().finish();
            times.values.push_back(clock.milliseconds());
            ++result_.frames;
            check_scripts(scene.app().world(), number);
            if (draw) sum_passes(scene.renderer());
            names.update(scene.app().world());
            PlayedFrame frame(number, scene.app(), scene.renderer(), names, allocations_of_frame(scene.app().world()));
            look(frame);
        }
        result_.curves.push_back(std::move(times));
    }

    /// Opens the scene once more to see how long that, or its frames, take; seconds.
    double measure(TimeOf of, const std::vector<std::string>& more_sets) {
        const FrameClock loading;
        PlayedScene scene(*context_, play_, more_sets);
        if (of == TimeOf::load) return 1e-3 * loading.milliseconds();
        double best = std::numeric_limits<double>::max();
        const std::int64_t last = std::min(play_.frames, measured_frames);
        while (scene.next_frame() < last) {
            const bool counts = scene.next_frame() >= std::min(warm_up_frames, last - 1);
            const FrameClock clock;
            scene.step(true);
            scene.renderer().finish();
            if (counts) best = std::min(best, 1e-3 * clock.milliseconds());
        }
        return best;
    }

private:
    void choose_strip() {
        if (options_.evidence.empty() || options_.from >= play_.frames) return;
        const std::int64_t count = play_.frames - options_.from, shown = std::min(strip_frames, count);
        for (std::int64_t i = 0; i < shown; ++i)
            strip_.insert(options_.from + (shown == 1 ? 0 : i * (count - 1) / (shown - 1)));
    }

    [[nodiscard]] bool is_drawn(std::int64_t number) const {
        if (strip_.contains(number)) return true;
        return std::ranges::any_of(play_.expectations, [&](const auto& expectation) {
            const FrameRange frames = expectation->frames();
            switch (expectation->need()) {
            case FrameNeed::nothing:
            case FrameNeed::logic:
                return false;
            case FrameNeed::drawn:
                return number >= options_.from && frames.contains(number);
            case FrameNeed::drawn_twice:
                return (number >= options_.from && frames.contains(number)) ||
                       (number + 1 >= options_.from && frames.contains(number + 1));
            }
            return false;
        });
    }

    static void check_scripts(const World& world, std::int64_t number) {
        const ScriptErrors* scripts = world.find_resource<ScriptErrors>();
        if (scripts && !scripts->errors.empty())
            throw Error(fmt::format("script error at frame {}: {}", number, scripts->errors.front().message));
    }

    void look(PlayedFrame& frame) {
        for (const auto& expectation : play_.expectations)
            if (expectation->need() != FrameNeed::nothing && frame.number() >= options_.from &&
                expectation->frames().contains(frame.number()))
                expectation->look(frame);
        if (!strip_.contains(frame.number())) return;
        StripFrame shown{frame.number(), options_.evidence / fmt::format("strip-{:06}.png", frame.number())};
        assets::write_png(shown.picture, picture::shrunk(frame.picture(), strip_width));
        result_.strip.push_back(std::move(shown));
    }

    void sum_passes(Renderer& renderer) {
        for (const gpu::PassStats& pass : renderer.pass_stats()) {
            auto sum = std::ranges::find(result_.passes, pass.name, &PassSummary::name);
            if (sum == result_.passes.end()) sum = result_.passes.insert(sum, PassSummary{.name = pass.name});
            sum->run += pass.state == gpu::PassState::run;
            sum->reused += pass.state == gpu::PassState::reused;
            sum->culled += pass.state == gpu::PassState::culled;
            if (pass.state != gpu::PassState::run) continue;
            sum->cpu_ms += pass.cpu_ms;
            sum->gpu_ms += pass.gpu_ms.value_or(0.0);
        }
    }

    const PlayDocument& play_;
    const PlayOptions& options_;
    PlayResult& result_;
    std::unique_ptr<gpu::Context> context_; // outlives the scenes, which own GPU objects
    std::set<std::int64_t> strip_;
};

void judge(const PlayDocument& play, const PlayOptions& options, Run& run, PlayResult& result) {
    JudgeContext context{options.update, options.evidence, {}, options.from, {}};
    context.measure = [&](TimeOf of, const std::vector<std::string>& sets) { return run.measure(of, sets); };
    for (std::size_t i = 0; i < play.expectations.size(); ++i) {
        context.stem = fmt::format("expect-{:03}", i);
        result.expectations.push_back(play.expectations[i]->result(context));
    }
}

/// Plays and judges; throws what goes wrong.
void play_and_judge(const PlayDocument& play, const PlayOptions& options, PlayResult& result) {
    Run run(play, options, result);
    run.play();
    judge(play, options, run, result);
}

/// A command that plays the test again, from its first frame that fails.
std::string replay_command(const PlayResult& result, const PlayDocument* play, const PlayOptions& options) {
    std::string command =
        "hachure play " + shell_text(std::filesystem::absolute(result.file).lexically_normal().string());
    if (options.backend) command += " --backend " + std::string(gpu::to_string(*options.backend));
    std::int64_t first = std::numeric_limits<std::int64_t>::max();
    for (std::size_t i = 0; play && i < result.expectations.size(); ++i)
        if (!result.expectations[i].passed) first = std::min(first, play->expectations[i]->first_look());
    if (first > 0 && first < result.frames) command += fmt::format(" --from {}", first);
    return command;
}

} // namespace

PlayResult run_play(const std::filesystem::path& file, const PlayOptions& options) {
    PlayResult result;
    result.file = file;
    const FrameClock clock;
    std::optional<PlayDocument> play;
    try {
        play = read_play(known_types(), file);
        result.doc = play->doc;
        result.width = play->size.width;
        result.height = play->size.height;
        if (options.from >= play->frames)
            throw Error(file.string(), fmt::format("has no frame {}: its last is {}", options.from, play->frames - 1));
        play_and_judge(*play, options, result);
    } catch (const std::bad_alloc&) {
        result.error = "not enough memory";
    } catch (const std::exception& error) {
        result.error = error.what();
    }
    for (std::size_t i = result.expectations.size(); play && i < play->expectations.size(); ++i)
        result.expectations.push_back(play->expectations[i]->unjudged("not judged: the run ended early"));
    result.passed = result.error.empty() &&
                    std::ranges::all_of(result.expectations, [](const ExpectationResult& e) { return e.passed; });
    result.replay = replay_command(result, play ? &*play : nullptr, options);
    result.seconds = 1e-3 * clock.milliseconds();
    return result;
}

} // namespace hachure::play
