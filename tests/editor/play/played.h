#pragma once

#include <hachure/editor/play/play_pool.h>
#include <hachure/editor/play/play_result_json.h>
#include <hachure/editor/play/play_runner.h>
#include <hachure/runtime/parallel.h>
#include <hachure/tests/support/process.h>
#include <hachure/tests/support/temp_folder.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <iterator>
#include <string>
#include <vector>

namespace hachure::test {

/// The models of tests/playback.
inline std::string playback_model(const std::string& name) {
    return (std::filesystem::path(HACHURE_SOURCE_DIR) / "tests/playback/models" / name).string();
}

/// A test of the shapes at rest, with one expectation.
inline nlohmann::json still_test(nlohmann::json expectation) {
    return {{"hachure_play", 1},
            {"scene", playback_model("shapes.glb")},
            {"set", {"animation.playing=false"}},
            {"size", {128, 96}},
            {"frames", 4},
            {"expect", nlohmann::json::array({std::move(expectation)})}};
}

/// Tests that play tests, each in a process of its own: forked, without the start of a program, where this one has but
/// one thread, else the program's worker.
class Played : public testing::Test {
protected:
    play::PlayResult play(const nlohmann::json& document, const play::PlayOptions& options = {}, int threads = 0) {
        const std::filesystem::path file = folder_.write("t.play.json", document.dump(1));
        const std::filesystem::path result = folder_ / "result.json";
        std::filesystem::remove(result);
        const auto work = [&] {
            if (threads > 0) set_thread_limit(threads);
            play::play_as_worker(file, options, result);
            return 0;
        };
        const ProcessResult process =
            has_one_thread() ? Process(work).wait() : run_process(worker_command(file, options, threads, result));
        EXPECT_EQ(process.exit_code, 0) << "signal " << process.signal << "\n" << process.err;
        return play::result_from_json(nlohmann::json::parse(file_text(result)));
    }

    TempFolder folder_;

private:
    static bool has_one_thread() {
        return std::distance(std::filesystem::directory_iterator("/proc/self/task"), {}) == 1;
    }

    static std::vector<std::string> worker_command(const std::filesystem::path& file, const play::PlayOptions& options,
                                                   int threads, const std::filesystem::path& result) {
        std::vector<std::string> command{HACHURE_PROGRAM, "play", "--worker", result, file};
        command.insert(command.end(), {"--from", std::to_string(options.from)});
        if (options.update) command.emplace_back("--update");
        if (!options.evidence.empty()) command.insert(command.end(), {"--evidence", options.evidence});
        if (threads > 0) command.insert(command.end(), {"--threads", std::to_string(threads)});
        return command;
    }
};

/// Why the first expectation failed; what went wrong with the run where something did; empty when all passed.
inline std::string failure(const play::PlayResult& result) {
    if (!result.error.empty()) return result.error;
    for (const play::ExpectationResult& e : result.expectations)
        if (!e.passed) return e.reason.empty() ? "no reason" : e.reason;
    return result.passed ? "" : "not passed";
}

} // namespace hachure::test
