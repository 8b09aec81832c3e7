#include <hachure/runtime/assets/text_file.h>
#include <hachure/runtime/error.h>

#include <fstream>

namespace hachure::assets {

std::string read_text_file(const std::filesystem::path& path, std::size_t max_bytes) {
    std::error_code code;
    if (!std::filesystem::exists(path, code)) throw Error(path.string(), "there is no such file");
    if (!std::filesystem::is_regular_file(path, code)) throw Error(path.string(), "is not a file that can be read");
    const std::uintmax_t size = std::filesystem::file_size(path, code);
    if (code || size > max_bytes) throw Error(path.string(), "is larger than " + std::to_string(max_bytes) + " bytes");
    std::ifstream file(path, std::ios::binary);
    std::string text(static_cast<std::size_t>(size), '\0');
    if (!file.read(text.data(), static_cast<std::streamsize>(size))) throw Error(path.string(), "can't be read");
    return text;
}

} // namespace hachure::assets
