#include <hachure/runtime/assets/atomic_file.h>
#include <hachure/runtime/error.h>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <system_error>

namespace hachure::assets {

AtomicFile::AtomicFile(const std::filesystem::path& target)
    : target_(target), name_(target.parent_path() / ("." + target.filename().string() + ".XXXXXX")) {
    std::error_code ignored; // what else is wrong with the path shows when it is opened
    if (std::filesystem::is_directory(target, ignored))
        throw Error(target.string(), "is a folder, not a file to write");
    descriptor_ = ::mkstemp(name_.data());
    if (descriptor_ < 0) fail();
}

AtomicFile::~AtomicFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
    if (!committed_) ::unlink(name_.c_str());
}

void AtomicFile::write(std::span<const std::byte> bytes) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) fail();
        bytes = bytes.subspan(static_cast<std::size_t>(written));
    }
}

void AtomicFile::commit() {
    // mkstemp makes private files; the result has the mode any program would give it.
    const mode_t mask = ::umask(0);
    ::umask(mask);
    ::fchmod(descriptor_, 0666 & ~mask);
    const int closed = ::close(descriptor_);
    descriptor_ = -1;
    if (closed != 0 || ::rename(name_.c_str(), target_.c_str()) != 0) fail();
    committed_ = true;
}

void AtomicFile::fail() { throw Error(target_.string(), "can't be written", std::strerror(errno)); }

void write_file_atomically(const std::filesystem::path& path, std::span<const std::byte> bytes) {
    AtomicFile file(path);
    file.write(bytes);
    file.commit();
}

} // namespace hachure::assets
