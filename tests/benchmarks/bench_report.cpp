#include <hachure/runtime/assets/atomic_file.h>
#include <hachure/tests/benchmarks/bench_report.h>

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <span>

namespace hachure::bench {

Arguments parse_arguments(int argc, char** argv, std::string_view what_it_measures) {
    Arguments arguments;
    const auto usage = [&] {
        const std::string text =
            fmt::format("{}\nusage: {} [--quick] [--csv FILE] [MODEL]\n", what_it_measures, argv[0]);
        std::fputs(text.c_str(), stderr);
        std::exit(2);
    };
    for (int i = 1; i < argc; ++i) {
        const std::string_view argument = argv[i];
        if (argument == "--quick")
            arguments.quick = true;
        else if (argument == "--csv" && i + 1 < argc)
            arguments.csv = argv[++i];
        else if (!argument.starts_with("-") && arguments.model.empty())
            arguments.model = argument;
        else
            usage();
    }
    return arguments;
}

void Report::add(std::string_view name, double value, std::string_view unit) {
    rows_.push_back({std::string(name), value, std::string(unit), {}});
}

void Report::add_limited(std::string_view name, double value, std::string_view unit, double limit) {
    rows_.push_back({std::string(name), value, std::string(unit), limit});
}

int Report::finish() const {
    bool passed = true;
    std::string csv = "name,value,unit,limit,verdict\n";
    std::string table = fmt::format("{:<44} {:>10} {:<10} {:>8}  {}\n", "name", "value", "unit", "limit", "verdict");
    for (const Row& row : rows_) {
        const std::string limit = row.limit ? fmt::format("{:.4g}", *row.limit) : "";
        const bool holds = !row.limit || row.value <= *row.limit;
        const std::string verdict = !row.limit ? "" : arguments_.quick ? "not judged" : holds ? "holds" : "falls short";
        passed = passed && holds;
        table += fmt::format("{:<44} {:>10.6g} {:<10} {:>8}  {}\n", row.name, row.value, row.unit, limit, verdict);
        csv += fmt::format("{},{:.6g},{},{},{}\n", row.name, row.value, row.unit, limit, verdict);
    }
    std::fputs(table.c_str(), stdout);
    if (!arguments_.csv.empty())
        assets::write_file_atomically(arguments_.csv, std::as_bytes(std::span(csv.data(), csv.size())));
    return passed || arguments_.quick ? 0 : 1;
}

double median(std::vector<double> values) {
    if (values.empty()) return 0.0;
    std::ranges::sort(values);
    const std::size_t middle = values.size() / 2;
    return values.size() % 2 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
}

double now_ms() {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

} // namespace hachure::bench
