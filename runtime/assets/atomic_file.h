#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>

namespace hachure::assets {

/// A file that takes its place only when it is whole: what is written goes to a temporary neighbour of the target,
/// which `commit` renames over it. Readers see the old file or the whole new one; without a commit nothing is left
/// behind.
class AtomicFile {
public:
    /// Makes the temporary file. Throws Error naming `target` (no such folder, no permission, it is a folder).
    explicit AtomicFile(const std::filesystem::path& target);
    ~AtomicFile();
    AtomicFile(const AtomicFile&) = delete;
    AtomicFile& operator=(const AtomicFile&) = delete;

    /// Appends `bytes`. Throws Error naming the target (disk full, ...).
    void write(std::span<const std::byte> bytes);

    /// Renames the file to its place; no more is written then. Throws Error naming the target.
    void commit();

    [[nodiscard]] const std::filesystem::path& target() const { return target_; }

    /// Where the bytes are until `commit`, for libraries that write files by name.
    [[nodiscard]] const std::string& temporary_name() const { return name_; }

private:
    [[noreturn]] void fail();

    std::filesystem::path target_;
    std::string name_;
    int descriptor_ = -1;
    bool committed_ = false;
};

/// Writes `bytes` to `path` by way of an AtomicFile. Throws Error naming `path`.
void write_file_atomically(const std::filesystem::path& path, std::span<const std::byte> bytes);

} // namespace hachure::assets
