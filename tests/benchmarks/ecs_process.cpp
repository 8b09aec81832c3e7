#include <hachure/runtime/error.h>
#include <hachure/tests/benchmarks/ecs_process.h>

#include <cstdlib>
#include <fstream>
#include <string>
#include <string_view>

namespace hachure::bench {
namespace {

/// The value of a line "KEY:   123 kB" of /proc/self/status, in bytes.
std::size_t status_bytes(std::string_view key) {
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);)
        if (line.starts_with(key)) return 1024 * std::strtoull(line.c_str() + key.size(), nullptr, 10);
    throw Error("/proc/self/status", "says nothing about memory", key);
}

} // namespace

std::size_t resident_bytes() { return status_bytes("VmRSS:"); }
std::size_t peak_resident_bytes() { return status_bytes("VmHWM:"); }

} // namespace hachure::bench
