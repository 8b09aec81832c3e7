#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace hachure::test {

/// One #include of a file of ours by another.
struct Include {
    std::string from; ///< both relative to the top of the tree, with '/'
    std::string to;
};

/// Every `#include <hachure/...>` of the .h and .cpp files of these folders; empty for a folder that is not there.
std::vector<Include> source_includes(const std::vector<std::string>& folders);

/// Every `#include "..."` below shaders/.
std::vector<Include> shader_includes();

/// Names of the folders in this one, or of its files with the extension, without it; sorted.
std::vector<std::string> folders_in(const std::string& folder);
std::vector<std::string> stems_in(const std::string& folder, const std::string& extension);

/// The first `count` parts of a path: ("systems/gooch/gooch.cpp", 2) gives "systems/gooch".
std::string top(const std::string& path, int count);

std::filesystem::path source_root();

} // namespace hachure::test
