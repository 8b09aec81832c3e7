#pragma once

#include <filesystem>
#include <string>

namespace hachure::assets {

/// The extension of a file's name in lower case, with its dot: ".png" for "Picture.PNG"; empty when there is none.
[[nodiscard]] std::string lower_extension(const std::filesystem::path& path);

} // namespace hachure::assets
