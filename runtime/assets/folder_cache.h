#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace hachure::assets {

/// Where results are kept between runs of the program: what HACHURE_CACHE names, or else hachure in $XDG_CACHE_HOME, or
/// else ~/.cache/hachure. None when HACHURE_CACHE is "off" or no home is known; relative paths in the last two do not
/// count. The folder need not exist.
[[nodiscard]] std::optional<std::filesystem::path> user_cache_folder();

/// Files under a size all together, of which those used longest ago go first; several programs may share it. Nothing
/// here throws: what cannot be read is missing, and what cannot be written is not kept.
class FolderCache {
public:
    /// The folder is made by the first `store`. Whatever lies in it is the cache's to remove.
    FolderCache(std::filesystem::path folder, std::uintmax_t limit);

    /// The bytes of a file, none when it is missing or larger than `most`; marks it as used.
    [[nodiscard]] std::optional<std::vector<std::byte>> load(const std::string& name, std::uintmax_t most) const;

    /// Writes a file, whole or not at all, and removes old ones.
    void store(const std::string& name, std::span<const std::byte> bytes) const;

private:
    void trim(const std::filesystem::path& keep) const;

    std::filesystem::path folder_;
    std::uintmax_t limit_;
};

} // namespace hachure::assets
