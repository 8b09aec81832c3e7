// What implicit brushes cost, each part against full-screen passes in the same run.

#include <hachure/runtime/error.h>
#include <hachure/tests/benchmarks/bench_report.h>
#include <hachure/tests/benchmarks/implicit_brush_features.h>

#include <cstdio>

namespace {

int run(int argc, char** argv) {
    using namespace hachure;
    const bench::Arguments arguments =
        bench::parse_arguments(argc, argv, "Cost of implicit brushes, for bunny in half of a view of 1024x768.");
    bench::Report report(arguments);
    const std::unique_ptr<gpu::Context> context = gpu::make_context();
    bench::report_features(report, *context, arguments.model, arguments.quick);
    return report.finish();
}

} // namespace

int main(int argc, char** argv) {
    try {
        return run(argc, argv);
    } catch (const hachure::Error& error) {
        std::fprintf(stderr, "bench_implicit_brush: error: %s\n", error.what());
        return 1;
    }
}
