#include <hachure/runtime/error.h>
#include <hachure/tests/benchmarks/bench_report.h>
#include <hachure/tests/benchmarks/ecs_measure.h>

#include <malloc.h>

#include <algorithm>

namespace hachure::bench {
namespace {

double time(const std::function<double()>& run) {
    // Memory is fresh for everyone: what the one before has freed goes back to the system.
    ::malloc_trim(0);
    return run();
}

bool all_hold(const Group& group, const std::vector<double>& floors, const std::vector<std::vector<double>>& samples) {
    for (std::size_t i = 0; i < group.cases.size(); ++i)
        if (const auto& limit = group.cases[i].limit;
            limit && std::ranges::min(samples[i]) > *limit * std::ranges::min(floors))
            return false;
    return true;
}

} // namespace

void require(bool holds, const char* what) {
    if (!holds) throw Error("the benchmark has not done its work", what);
}

std::vector<Result> measure(const Group& group, const Effort& effort) {
    std::vector<double> floors;
    std::vector<std::vector<double>> samples(group.cases.size());
    const Stopwatch watch;
    for (int round = 0;; ++round) {
        const double seconds = 1e-9 * watch.ns();
        const bool enough = round >= effort.max_rounds || (round >= effort.min_rounds && seconds > effort.seconds);
        if (enough && (seconds > effort.patience || all_hold(group, floors, samples))) break;
        if (group.floor) floors.push_back(time(group.floor));
        for (std::size_t i = 0; i < samples.size(); ++i) samples[i].push_back(time(group.cases[i].run));
    }
    std::vector<Result> results;
    const double floor = floors.empty() ? 0.0 : std::ranges::min(floors);
    if (group.floor) results.push_back({group.floor_name, "", "ns", floor, median(floors), floor, {}});
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const Case& one = group.cases[i];
        results.push_back(
            {one.name, one.panel, one.unit, std::ranges::min(samples[i]), median(samples[i]), floor, one.limit});
    }
    return results;
}

} // namespace hachure::bench
