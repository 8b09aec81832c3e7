#pragma once

#include <hachure/tests/support/process.h>
#include <hachure/tests/support/temp_folder.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace hachure::test {

/// Runs the built program as a user would, in `folder`.
inline ProcessResult hachure_program(const TempFolder& folder, std::vector<std::string> arguments) {
    std::vector<std::string> command{HACHURE_PROGRAM};
    for (std::string& argument : arguments) command.push_back(std::move(argument));
    return run_process(command, folder.path());
}

/// A closed tetrahedron about the origin.
inline constexpr const char* tetrahedron_obj = "v 1 1 1\nv 1 -1 -1\nv -1 1 -1\nv -1 -1 1\n"
                                               "f 1 2 3\nf 1 3 4\nf 1 4 2\nf 2 4 3\n";

/// The command failed as promised: `code`, nothing on stdout, one line on stderr that says `text`.
inline testing::AssertionResult failed(const ProcessResult& result, int code, const std::string& text) {
    const auto lines = std::count(result.err.begin(), result.err.end(), '\n');
    if (result.exit_code == code && lines == 1 && result.out.empty() && result.err.starts_with("hachure: error: ") &&
        result.err.find(text) != std::string::npos)
        return testing::AssertionSuccess();
    return testing::AssertionFailure() << "exit " << result.exit_code << " (signal " << result.signal << "), wanted "
                                       << code << " with one line that says '" << text << "'\nstdout: " << result.out
                                       << "\nstderr: " << result.err;
}

/// The command succeeded and had nothing to say on stderr.
inline testing::AssertionResult succeeded(const ProcessResult& result) {
    if (result.exit_code == 0 && result.err.empty()) return testing::AssertionSuccess();
    return testing::AssertionFailure() << "exit " << result.exit_code << " (signal " << result.signal
                                       << ")\nstderr: " << result.err;
}

} // namespace hachure::test
