#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

namespace hachure::assets {

/// All of a text file of at most `max_bytes`. Throws Error when it is missing, a folder, unreadable or larger.
[[nodiscard]] std::string read_text_file(const std::filesystem::path& path, std::size_t max_bytes);

} // namespace hachure::assets
