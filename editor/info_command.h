#pragma once

#include <filesystem>

namespace CLI {
class App;
}

namespace hachure {

/// `hachure info`, as the user typed it.
struct InfoOptions {
    std::filesystem::path input;
};

void add_info_command(CLI::App& app, InfoOptions& options);

/// Prints what is in the file and what is wrong with it. Throws Error.
int run_info(const InfoOptions& options);

} // namespace hachure
