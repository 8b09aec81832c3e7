#pragma once

#include <filesystem>
#include <string>
#include <string_view>

/// Where a file that names other files may reach: its own folder and what lies below, nothing else.
namespace hachure::assets {

/// `%20` and the like replaced by their bytes; a '%' without two hexadecimal digits stays as it is.
[[nodiscard]] std::string percent_decode(std::string_view uri);

/// The path of the file that `uri` (percent-encoded, relative) names inside `file`. It need not exist.
///
/// Throws hachure::Error about `file`, at `where`, when the decoded uri is empty, is absolute, carries a scheme or a
/// drive (`http:`, `file:`, `C:`), holds a backslash or a NUL, or leaves the folder of `file`, be it by `..` or by a
/// symbolic link.
[[nodiscard]] std::filesystem::path resolve_beside(const std::filesystem::path& file, std::string_view uri,
                                                   std::string_view where = {});

} // namespace hachure::assets
