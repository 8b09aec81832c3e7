#include <hachure/runtime/assets/atomic_file.h>
#include <hachure/runtime/assets/file_bytes.h>
#include <hachure/runtime/assets/folder_cache.h>
#include <hachure/runtime/error.h>

#include <algorithm>
#include <cstdlib>
#include <string_view>
#include <system_error>

namespace hachure::assets {
namespace {

namespace fs = std::filesystem;

/// What an environment variable says, or nothing.
std::string_view variable(const char* name) {
    const char* value = std::getenv(name);
    return value != nullptr ? value : "";
}

struct CachedFile {
    fs::file_time_type used;
    fs::path path;
    std::uintmax_t size;
};

std::vector<CachedFile> files_in(const fs::path& folder) {
    std::vector<CachedFile> files;
    std::error_code error;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
        std::error_code fault; // another program may have removed it
        if (!entry->is_regular_file(fault) || fault) continue;
        CachedFile file{entry->last_write_time(fault), entry->path(), 0};
        if (fault) continue;
        file.size = entry->file_size(fault);
        if (!fault) files.push_back(std::move(file));
    }
    return files;
}

} // namespace

std::optional<fs::path> user_cache_folder() {
    if (const std::string_view own = variable("HACHURE_CACHE"); !own.empty())
        return own == "off" ? std::nullopt : std::optional<fs::path>(own);
    const fs::path shared(variable("XDG_CACHE_HOME"));
    if (shared.is_absolute()) return shared / "hachure";
    const fs::path home(variable("HOME"));
    if (home.is_absolute()) return home / ".cache" / "hachure";
    return std::nullopt;
}

FolderCache::FolderCache(fs::path folder, std::uintmax_t limit) : folder_(std::move(folder)), limit_(limit) {}

std::optional<std::vector<std::byte>> FolderCache::load(const std::string& name, std::uintmax_t most) const {
    const fs::path path = folder_ / name;
    std::error_code error;
    if (!fs::is_regular_file(path, error)) return std::nullopt;
    try {
        std::vector<std::byte> bytes = read_file_bytes(path, most);
        fs::last_write_time(path, fs::file_time_type::clock::now(), error);
        return bytes;
    } catch (const Error&) {
        return std::nullopt;
    }
}

void FolderCache::store(const std::string& name, std::span<const std::byte> bytes) const {
    std::error_code error;
    if (bytes.size() > limit_) return;
    fs::create_directories(folder_, error);
    if (error) return;
    try {
        write_file_atomically(folder_ / name, bytes);
    } catch (const Error&) {
        return;
    }
    trim(folder_ / name);
}

/// The file just written stays, even where clocks disagree.
void FolderCache::trim(const fs::path& keep) const {
    std::vector<CachedFile> files = files_in(folder_);
    std::ranges::sort(files, [](const CachedFile& a, const CachedFile& b) { return a.used < b.used; });
    std::uintmax_t total = 0;
    for (const CachedFile& file : files) total += file.size;
    for (const CachedFile& file : files) {
        if (total <= limit_) return;
        if (file.path == keep) continue;
        std::error_code error;
        fs::remove(file.path, error);
        total -= file.size;
    }
}

} // namespace hachure::assets
