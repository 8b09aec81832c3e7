#include <hachure/editor/interrupt.h>
#include <hachure/editor/play/find_tests.h>
#include <hachure/editor/play/junit.h>
#include <hachure/editor/play/play_command.h>
#include <hachure/editor/play/play_pool.h>
#include <hachure/editor/play/play_report.h>
#include <hachure/editor/play/play_runner.h>
#include <hachure/editor/play/record.h>
#include <hachure/editor/usage_error.h>
#include <hachure/runtime/error.h>
#include <hachure/runtime/parallel.h>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <optional>

namespace hachure {
namespace {

using play::ExpectationResult;
using play::PlayResult;

constexpr int max_jobs = 1024;

/// A folder for this run alone, which goes with it.
class RunFolder {
public:
    RunFolder() {
        std::string name = (std::filesystem::temp_directory_path() / "hachure-play-XXXXXX").string();
        if (!::mkdtemp(name.data())) throw Error(name, "no temporary folder can be made");
        path_ = name;
    }
    ~RunFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    RunFolder(const RunFolder&) = delete;
    RunFolder& operator=(const RunFolder&) = delete;
    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
};

std::optional<gpu::Backend> chosen_backend(const PlayCommandOptions& options) {
    if (options.backend.empty()) return std::nullopt;
    const std::optional<gpu::Backend> backend = gpu::backend_from_string(options.backend);
    if (!backend) throw UsageError("--backend: '" + options.backend + "' is none of auto, egl, osmesa, glfw");
    return backend;
}

play::PlayOptions play_options(const PlayCommandOptions& options) {
    return {options.update, options.from, options.evidence, chosen_backend(options)};
}

/// What every test's process is told.
std::vector<std::string> worker_options(const PlayCommandOptions& options) {
    const int threads = options.threads > 0 ? options.threads : std::max(1, thread_limit() / options.jobs);
    std::vector<std::string> result{"--threads", std::to_string(threads), "--from", std::to_string(options.from)};
    if (options.update) result.emplace_back("--update");
    if (!options.backend.empty()) result.insert(result.end(), {"--backend", options.backend});
    return result;
}

void print(const PlayResult& result) {
    std::printf("%s %s (%.2f s)\n", result.passed ? "ok    " : "FAILED", result.file.c_str(), result.seconds);
    if (!result.error.empty()) std::printf("       %s\n", Error(result.error).what());
    for (const ExpectationResult& e : result.expectations) {
        if (e.renewed) std::printf("       %s\n", Error(e.reason).what());
        // What was not judged only repeats the error.
        if (!e.passed && (result.error.empty() || !e.reason.starts_with("not judged")))
            std::printf("       %s: %s: %s\n", e.pointer.c_str(), Error(e.what).what(), Error(e.reason).what());
    }
    if (!result.passed) std::printf("       again: %s\n", result.replay.c_str());
    std::fflush(stdout);
}

int summarize(std::span<const PlayResult> results) {
    const auto failed = std::ranges::count(results, false, &PlayResult::passed);
    const std::string tests = results.size() == 1 ? "playback test" : "playback tests";
    if (failed == 0) {
        std::printf("%zu %s passed\n", results.size(), tests.c_str());
        return 0;
    }
    std::fflush(stdout);
    throw Error(fmt::format("{} of {} {} failed", failed, results.size(), tests));
}

void check_usage(const PlayCommandOptions& options) {
    static_cast<void>(chosen_backend(options));
    if (!options.record.empty() && options.tests.size() != 1)
        throw UsageError("--record: takes one test, whose scene is shown");
    if (options.update && options.from > 0) throw UsageError("--update: renews whole tests, not --from a frame on");
}

} // namespace

void add_play_command(CLI::App& app, PlayCommandOptions& options) {
    CLI::App* command =
        app.add_subcommand("play", "Play scripted tests and check what they expect; exit 1 when one fails");
    command->add_option("TEST", options.tests, "a .play.json file, or a folder that is searched for them")->required();
    command->add_option("--report", options.report, "DIR: write an HTML page with pictures and curves there");
    command->add_flag("--update", options.update, "write the golden pictures anew; look at them before keeping them");
    command->add_option("--jobs", options.jobs, "play N tests at once, each in a process of its own")
        ->type_name("N")
        ->check(CLI::Range(1, max_jobs));
    command->add_option("--from", options.from, "play frames before N without drawing or checking them")
        ->type_name("N")
        ->check(CLI::Range(std::int64_t{0}, play::max_frames));
    command->add_option("--junit", options.junit, "FILE: write the results as JUnit XML");
    command->add_option("--record", options.record,
                        "FILE.input.json: show the test's scene in a window and record what is done to it until the "
                        "window is closed");
    command
        ->add_option("--threads", options.threads,
                     "at most N threads a test (default: the machine's, shared by the jobs)")
        ->type_name("N")
        ->check(CLI::Range(1, 1024));
    command->add_option("--backend", options.backend, "instead of the tests' own: auto, egl, osmesa, glfw");
    command->add_option("--limit", options.limit_s, "seconds that one test may take")
        ->type_name("S")
        ->capture_default_str()
        ->check(CLI::Range(0.01, 1e6));
    command->add_option("--worker", options.worker)->group("");
    command->add_option("--evidence", options.evidence)->group("");
    command->footer("The format of tests is in docs/playback.md.\n"
                    "Examples: hachure play tests/playback --jobs 4 --report build/playback\n"
                    "          hachure play fox.play.json --update");
}

int run_play_command(const PlayCommandOptions& options) {
    check_usage(options);
    if (!options.worker.empty()) {
        if (options.threads > 0) set_thread_limit(options.threads);
        play::play_as_worker(options.tests.at(0), play_options(options), options.worker);
        return 0;
    }
    const std::vector<std::filesystem::path> tests = play::find_tests(options.tests);
    if (!options.record.empty()) return play::record(tests.at(0), options.record);
    const InterruptWatch watch; // outlives the folder, which a signal must not leave behind
    const RunFolder folder;
    const play::PoolOptions pool{options.jobs, options.limit_s, folder.path(), !options.report.empty(),
                                 worker_options(options)};
    const std::vector<PlayResult> results = play::play_in_processes(tests, pool, print);
    if (!options.report.empty()) play::write_report(options.report, results);
    if (!options.junit.empty()) play::write_junit(options.junit, results);
    return summarize(results);
}

} // namespace hachure
