#pragma once

#include <hachure/tests/editor/forked_command.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace hachure::test {

/// What the program may use on a small file, whatever is wrong with it.
inline constexpr double cpu_limit_s = 2.0;
inline constexpr double memory_limit_mib = 1024.0;

#if defined(__SANITIZE_ADDRESS__)
inline constexpr bool costs_are_real = false; // sanitizers take time and memory of their own
#else
inline constexpr bool costs_are_real = true;
#endif

/// How many lines of stderr are errors; the others are our warnings.
inline long error_lines(const std::string& err) {
    long errors = 0;
    for (std::size_t at = 0; at < err.size();) {
        const std::size_t end = std::min(err.find('\n', at), err.size());
        const std::string line = err.substr(at, end - at);
        if (!line.starts_with("hachure: warning: ")) ++errors;
        at = end + 1;
    }
    return errors;
}

/// The promise for any input: drawn or refused, never a crash; refused with one line that names the file; cheap.
inline testing::AssertionResult is_safe(const ProcessResult& result, const std::string& file) {
    const auto fail = [&](const std::string& what) {
        return testing::AssertionFailure()
               << file << " " << what << "\n  exit " << result.exit_code << ", signal " << result.signal << ", "
               << result.cpu_seconds << " s, " << result.max_rss_mib << " MiB\n  stderr: " << result.err;
    };
    if (result.signal != 0) return fail("crashes the program");
    if (result.exit_code != 0 && result.exit_code != 1) return fail("ends it with a code that means something else");
    if (error_lines(result.err) != result.exit_code) return fail("is not refused with one line");
    if (result.exit_code == 1 && result.err.find("hachure: error: " + file + ": ") == std::string::npos)
        return fail("is refused without its name");
    if (costs_are_real && result.cpu_seconds > cpu_limit_s) return fail("takes too long");
    if (costs_are_real && result.max_rss_mib > memory_limit_mib) return fail("takes too much memory");
    return testing::AssertionSuccess();
}

} // namespace hachure::test
