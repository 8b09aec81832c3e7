#pragma once

#include <hachure/editor/play/play_result.h>

#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace hachure::play {

/// How tests are spread over processes.
struct PoolOptions {
    int jobs = 1;                     ///< processes at once
    double limit_s = 300.0;           ///< of wall clock for one test; what takes longer is ended, and failed
    std::filesystem::path folder;     ///< an existing empty folder for what processes tell, and for evidence
    bool evidence = false;            ///< whether tests leave pictures there for a report
    std::vector<std::string> options; ///< of the command line, for every test's own process
};

/// Plays each test in a process of this program's own, so that a test that crashes or hangs is a failed test and
/// nothing else. Calls `done` in the order of the files, as soon as a result and those before it are there. Returns all
/// results in that order. Throws Error when a signal interrupts it (InterruptWatch) or no process can be started; none
/// is left behind then.
std::vector<PlayResult> play_in_processes(std::span<const std::filesystem::path> files, const PoolOptions& options,
                                          const std::function<void(const PlayResult&)>& done);

/// What such a process does: plays the test, writes its result to `result_file`.
void play_as_worker(const std::filesystem::path& file, const struct PlayOptions& options,
                    const std::filesystem::path& result_file);

} // namespace hachure::play
