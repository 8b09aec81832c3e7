#include <hachure/runtime/assets/atomic_file.h>
#include <hachure/tests/benchmarks/ecs_page.h>

#include <fmt/format.h>

#include <fstream>
#include <string>
#include <thread>

namespace hachure::bench {
namespace {

std::string processor() {
    std::ifstream info("/proc/cpuinfo");
    for (std::string line; std::getline(info, line);)
        if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
    return "an unknown processor";
}

std::string compiler() {
#ifdef __clang__
    return fmt::format("clang {}", __clang_version__);
#else
    return fmt::format("g++ {}", __VERSION__);
#endif
}

std::string row(const Result& result) {
    if (!result.limit)
        return fmt::format("| {} | {:.4g} {} | {:.4g} | | | |\n", result.name, result.best, result.unit, result.median);
    return fmt::format("| {} | {:.4g} {} | {:.4g} | {:.2f} | {} | {} |\n", result.name, result.best, result.unit,
                       result.median, result.ratio(), *result.limit,
                       result.ratio() <= *result.limit ? "holds" : "falls short");
}

} // namespace

void write_page(const std::filesystem::path& path, std::span<const Result> results, std::size_t count) {
    std::string page = fmt::format(R"(# What the world's operations cost

Made by `./dev charts ecs`; don't edit. {} entities, each with two components of 12 bytes, on {}, {} cores, one thread;
{}.

*best* and *median* are over many short rounds, per entity where the unit is ns. *over raw* is the best of the row over
the best of the floor of its part, which is timed in turn with it, for longer while a limit is not met: `p[i] += v[i]`
over two arrays for walking, `push_back` into two vectors that start empty for everything that changes the world's
structure, and for reading at random `p[index[id]]`: what arrays cost where things have ids because some of them go.
Memory is fresh in every round, for worlds and for vectors.

- *Walking* beats plain vectors because a world's memory comes in large pages.
- *Adding and removing* one component is limited for `Storage::sparse`, which is for components that come and go. The
  rows without a limit are for tables, where all 32 bytes of the entity move: what that costs is repaid by each walk.
- *Reading at random* takes three cache misses per entity, for the slot of the handle and for each component, as the
  floor does. What they cost depends on how many are on their way at once, and so on how few instructions stand between
  them: `each_of` asks for those of 32 entities before it visits the first, and `get` has few. A core whose other half
  is busy keeps half as many on the way, which `get` feels most.
- *Changes* are found through the queue while they are few and by a sweep beyond 3 %; the rows with a name behind them
  force one way.

![Cost per entity against the number of entities](charts/ecs.svg)

| what | best | median | over raw | limit | |
|---|---:|---:|---:|---:|---|
)",
                                   count, processor(), std::thread::hardware_concurrency(), compiler());
    for (const Result& result : results) page += row(result);
    assets::write_file_atomically(path, std::as_bytes(std::span(page.data(), page.size())));
}

} // namespace hachure::bench
