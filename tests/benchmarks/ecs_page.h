#pragma once

#include <hachure/tests/benchmarks/ecs_measure.h>

#include <cstddef>
#include <filesystem>
#include <span>

namespace hachure::bench {

/// Writes the page docs/ecs-benchmark.md: what was measured on `count` entities, on which machine, by which command.
void write_page(const std::filesystem::path& path, std::span<const Result> results, std::size_t count);

} // namespace hachure::bench
