#pragma once

#include <filesystem>

namespace CLI {
class App;
}

namespace hachure {

/// `hachure convert`, as the user typed it.
struct ConvertOptions {
    std::filesystem::path input, output;
};

void add_convert_command(CLI::App& app, ConvertOptions& options);

/// Makes a glTF file of a scene or a model, or a scene of a model. Throws Error, and UsageError for other extensions.
int run_convert(const ConvertOptions& options);

} // namespace hachure
