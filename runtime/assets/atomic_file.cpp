#include <hachure/runtime/assets/atomic_file.h>
#include <hachure/runtime/error.h>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <string>
#include <system_error>

namespace hachure::assets {
namespace {

/// A file that removes itself unless it was renamed to where it belongs.
class TemporaryFile {
public:
    explicit TemporaryFile(const std::filesystem::path& target)
        : target_(target), name_(target.parent_path() / ("." + target.filename().string() + ".XXXXXX")) {
        descriptor_ = ::mkstemp(name_.data());
        if (descriptor_ < 0) fail("can't be written");
    }
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;
    ~TemporaryFile() {
        if (descriptor_ >= 0) ::close(descriptor_);
        if (!committed_) ::unlink(name_.c_str());
    }

    void write(std::span<const std::byte> bytes) {
        while (!bytes.empty()) {
            const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
            if (written < 0 && errno == EINTR) continue;
            if (written < 0) fail("can't be written");
            bytes = bytes.subspan(static_cast<std::size_t>(written));
        }
    }

    void commit() {
        // mkstemp makes private files; the result has the mode any program would give it.
        const mode_t mask = ::umask(0);
        ::umask(mask);
        ::fchmod(descriptor_, 0666 & ~mask);
        const int closed = ::close(descriptor_);
        descriptor_ = -1;
        if (closed != 0 || ::rename(name_.c_str(), target_.c_str()) != 0) fail("can't be written");
        committed_ = true;
    }

private:
    [[noreturn]] void fail(const char* fault) {
        const int code = errno;
        if (descriptor_ >= 0) {
            ::close(descriptor_);
            ::unlink(name_.c_str());
        }
        throw Error(target_.string(), fault, std::strerror(code));
    }

    std::filesystem::path target_;
    std::string name_;
    int descriptor_ = -1;
    bool committed_ = false;
};

} // namespace

void write_file_atomically(const std::filesystem::path& path, std::span<const std::byte> bytes) {
    std::error_code ignored; // what is wrong with the path shows when it is opened
    if (std::filesystem::is_directory(path, ignored)) throw Error(path.string(), "is a folder, not a file to write");
    TemporaryFile file(path);
    file.write(bytes);
    file.commit();
}

} // namespace hachure::assets
