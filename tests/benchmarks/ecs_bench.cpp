// What the world's operations cost, each as a ratio to the same on raw arrays in the same run. The parts are ecs_*.cpp
// beside this file: one per kind of operation, the sweep for the chart, the page, and the world of ten million
// entities.

#include <hachure/runtime/error.h>
#include <hachure/tests/benchmarks/ecs_arguments.h>
#include <hachure/tests/benchmarks/ecs_chart.h>
#include <hachure/tests/benchmarks/ecs_groups.h>
#include <hachure/tests/benchmarks/ecs_huge.h>
#include <hachure/tests/benchmarks/ecs_page.h>

#include <cstdio>

namespace {

using namespace hachure::bench;

int report_table(const EcsArguments& arguments) {
    const std::size_t count = arguments.common.quick ? 1000 : 1'000'000;
    const Effort effort = arguments.common.quick ? Effort{} : Effort{9, 200, 5.0, 60.0};
    Report report(arguments.common);
    std::vector<Result> results;
    for (const auto& make : all_groups())
        for (const Result& result : measure(make(count), effort)) {
            report.add(result.name, result.best, result.unit);
            if (result.limit) report.add_limited(result.name + " / raw", result.ratio(), "ratio", *result.limit);
            results.push_back(result);
        }
    if (!arguments.markdown.empty()) write_page(arguments.markdown, results, count);
    return report.finish();
}

int run(const EcsArguments& arguments) {
    if (arguments.huge) return run_huge_world(arguments.common);
    if (arguments.chart.empty()) return report_table(arguments);
    write_sweep(arguments.chart, arguments.common.quick);
    return 0;
}

} // namespace

int main(int argc, char** argv) {
    try {
        return run(parse_ecs_arguments(argc, argv));
    } catch (const hachure::Error& error) {
        std::fprintf(stderr, "bench_ecs: error: %s\n", error.what());
        return 1;
    }
}
