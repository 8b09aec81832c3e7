#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace hachure {

/// `hachure play`, as the user typed it.
struct PlayCommandOptions {
    std::vector<std::filesystem::path> tests; ///< files, and folders that hold some
    std::filesystem::path report;             ///< a folder; empty for none
    std::filesystem::path junit;              ///< a file; empty for none
    std::filesystem::path record;             ///< a file; empty for none
    bool update = false;
    int jobs = 1;
    int threads = 0; ///< 0: those of the hardware, shared among the jobs
    std::int64_t from = 0;
    double limit_s = 300.0;
    std::string backend; ///< empty: the test's own

    // Of the processes that play one test each.
    std::filesystem::path worker;   ///< where the result goes; empty in the program that a user started
    std::filesystem::path evidence; ///< an existing folder; empty for none
};

void add_play_command(CLI::App& app, PlayCommandOptions& options);

/// Plays the tests, prints a line for each and a summary. Returns 1 when one failed. Throws Error and UsageError.
int run_play_command(const PlayCommandOptions& options);

} // namespace hachure
