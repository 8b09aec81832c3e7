#pragma once

namespace hachure {

/// The `hachure` program: reads the command line, runs the command, reports errors on stderr. Returns the exit code: 0
/// on success, 1 when the work failed, 2 on wrong usage.
int run_command_line(int argc, char** argv);

} // namespace hachure
