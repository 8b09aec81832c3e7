#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace hachure {

/// `hachure validate`, as the user typed it.
struct ValidateOptions {
    std::vector<std::filesystem::path> files;
};

/// What is wrong with a file and what is odd: one line each, with the file and the place in it.
struct Findings {
    std::vector<std::string> faults;
    std::vector<std::string> warnings;
};

/// A kind of file that can be checked without being used.
struct Checker {
    std::string ending; ///< of the file's name: ".scene.json"
    std::string what;   ///< "scene"
    std::function<Findings(const std::filesystem::path& file)> check;
};

/// The kinds there are; the first whose ending fits is a file's.
[[nodiscard]] std::vector<Checker> checkers();

void add_validate_command(CLI::App& app, ValidateOptions& options);

/// Prints every fault and every odd thing of the files to stdout, and how many there are. Returns 1 when there is a
/// fault, else 0.
int run_validate(const ValidateOptions& options);

} // namespace hachure
