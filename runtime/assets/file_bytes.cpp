#include <hachure/runtime/assets/file_bytes.h>
#include <hachure/runtime/error.h>

#include <fmt/format.h>

#include <fstream>
#include <system_error>

namespace hachure::assets {

std::vector<std::byte> read_file_bytes(const std::filesystem::path& file, std::uintmax_t limit) {
    namespace fs = std::filesystem;
    std::error_code error;
    const fs::file_status status = fs::status(file, error);
    if (status.type() == fs::file_type::not_found) throw Error(file.string(), "no such file");
    if (status.type() == fs::file_type::directory) throw Error(file.string(), "is a directory, not a file");
    if (error) throw Error(file.string(), "cannot be read: " + error.message());
    if (status.type() != fs::file_type::regular) throw Error(file.string(), "is not a regular file");

    const std::uintmax_t size = fs::file_size(file, error);
    if (error) throw Error(file.string(), "cannot be read: " + error.message());
    if (size > limit) throw Error(file.string(), fmt::format("is too large: {} bytes, at most {}", size, limit));

    std::ifstream stream(file, std::ios::binary);
    if (!stream) throw Error(file.string(), "cannot be opened for reading");
    std::vector<std::byte> bytes(static_cast<std::size_t>(size));
    stream.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    if (static_cast<std::uintmax_t>(stream.gcount()) != size) throw Error(file.string(), "cannot be read in full");
    return bytes;
}

} // namespace hachure::assets
