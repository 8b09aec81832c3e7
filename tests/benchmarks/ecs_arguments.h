#pragma once

#include <hachure/tests/benchmarks/bench_report.h>

#include <filesystem>

namespace hachure::bench {

/// How bench_ecs was called.
struct EcsArguments {
    Arguments common;
    bool huge = false;              ///< ten million entities instead of the timings
    std::filesystem::path chart;    ///< the sweep over sizes goes here as CSV, instead of the table
    std::filesystem::path markdown; ///< the table goes here, too
};

/// Reads the arguments; prints the usage and exits with 2 when they are wrong.
[[nodiscard]] EcsArguments parse_ecs_arguments(int argc, char** argv);

} // namespace hachure::bench
