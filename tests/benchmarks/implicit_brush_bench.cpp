// What implicit brushes cost. `--chart FILE [--quick]` writes the figures of error against time.

#include <hachure/runtime/error.h>
#include <hachure/tests/benchmarks/bench_report.h>
#include <hachure/tests/benchmarks/implicit_brush_convolution.h>
#include <hachure/tests/benchmarks/implicit_brush_feature_chart.h>
#include <hachure/tests/benchmarks/implicit_brush_features.h>
#include <hachure/tests/benchmarks/implicit_brush_noise.h>

#include <cstdio>
#include <fstream>
#include <memory>
#include <string_view>

namespace {

using namespace hachure;

void write_chart(const char* path, bool quick) {
    const std::unique_ptr<gpu::Context> context = gpu::make_context();
    std::ofstream file(path);
    file << "panel,series,label,x,y\n";
    bench::write_feature_rows(file, *context, quick);
    bench::write_convolution_rows(file, *context, {}, quick);
    if (!file.flush()) throw Error(path, "the file could not be written");
}

int run(int argc, char** argv) {
    if (argc >= 3 && std::string_view(argv[1]) == "--chart") {
        write_chart(argv[2], argc == 4 && std::string_view(argv[3]) == "--quick");
        return 0;
    }
    const bench::Arguments arguments =
        bench::parse_arguments(argc, argv, "Cost of implicit brushes, for bunny in half of a view of 1024x768.");
    bench::Report report(arguments);
    const std::unique_ptr<gpu::Context> context = gpu::make_context();
    const double pass = bench::report_features(report, *context, arguments.model, arguments.quick);
    bench::report_convolution(report, *context, arguments.model, arguments.quick);
    bench::add_noise_rows(report, *context, pass, arguments.quick);
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
