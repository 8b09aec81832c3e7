#pragma once

#include <hachure/tests/benchmarks/bench_report.h>

namespace hachure::bench {

/// Makes ten million entities (200 000 when quick) of many kinds with tags and trees, changes, destroys and replaces
/// some, and checks every count and sum on the way against arithmetic. Reports times and the peak of memory against
/// 4 GiB; the exit code. Throws Error when anything is not as expected.
[[nodiscard]] int run_huge_world(const Arguments& arguments);

} // namespace hachure::bench
