#pragma once

#include <hachure/editor/command_line.h>
#include <hachure/tests/support/process.h>

#include <string>
#include <vector>

namespace hachure::test {

/// One command in a process of its own that is forked, not started: the program's code without the 0.2 s that loading
/// its libraries takes.
inline ProcessResult forked_command(std::vector<std::string> arguments, const std::filesystem::path& folder = ".") {
    arguments.insert(arguments.begin(), "hachure");
    std::vector<char*> pointers = argument_pointers(arguments);
    return Process([&] { return run_command_line(static_cast<int>(arguments.size()), pointers.data()); }, folder)
        .wait();
}

} // namespace hachure::test
