#include <hachure/runtime/assets/atomic_file.h>
#include <hachure/tests/benchmarks/ecs_chart.h>
#include <hachure/tests/benchmarks/ecs_groups.h>

#include <fmt/format.h>

#include <cstdio>
#include <set>
#include <span>

namespace hachure::bench {
namespace {

/// "create: create_many" becomes "create_many".
std::string series(const std::string& name) { return name.substr(name.find(": ") + 2); }

/// The lines of one group: its series, and the floor once for each panel.
std::string lines(const Group& group, const Effort& effort, std::size_t count) {
    std::string text;
    std::set<std::string> panels;
    for (const Result& result : measure(group, effort)) {
        if (result.panel.empty()) continue;
        if (panels.insert(result.panel).second)
            text += fmt::format("{},raw arrays,{},{:.6g}\n", result.panel, count, result.floor);
        text += fmt::format("{},{},{},{:.6g}\n", result.panel, series(result.name), count, result.best);
    }
    return text;
}

/// The same group without what no panel shows.
Group charted(Group group) {
    std::erase_if(group.cases, [](const Case& one) { return one.panel.empty(); });
    return group;
}

} // namespace

void write_sweep(const std::filesystem::path& path, bool quick) {
    const std::vector<std::size_t> counts =
        quick
            ? std::vector<std::size_t>{100, 1000}
            : std::vector<std::size_t>{1000, 3000, 10'000, 30'000, 100'000, 300'000, 1'000'000, 3'000'000, 10'000'000};
    const Effort effort = quick ? Effort{} : Effort{3, 300, 1.0};
    std::string csv = "panel,series,entities,ns\n";
    for (const std::size_t count : counts) {
        std::fputs(fmt::format("bench_ecs: {} entities\n", count).c_str(), stderr);
        for (const auto& make : all_groups())
            if (const Group group = charted(make(count)); !group.cases.empty()) csv += lines(group, effort, count);
    }
    assets::write_file_atomically(path, std::as_bytes(std::span(csv.data(), csv.size())));
}

} // namespace hachure::bench
