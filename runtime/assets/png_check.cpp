#include <hachure/runtime/assets/png_check.h>
#include <hachure/runtime/error.h>

#include <zlib.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>

namespace hachure::assets {
namespace {

constexpr std::array<unsigned char, 8> signature{0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
constexpr std::size_t frame_bytes = 12; ///< of a chunk: length, type and checksum

std::uint32_t big_endian(std::span<const std::byte> bytes, std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i) value = value << 8 | std::to_integer<std::uint32_t>(bytes[at + i]);
    return value;
}

} // namespace

bool is_png(std::span<const std::byte> bytes) {
    return bytes.size() >= signature.size() &&
           std::equal(signature.begin(), signature.end(), bytes.begin(),
                      [](unsigned char a, std::byte b) { return a == std::to_integer<unsigned char>(b); });
}

void check_png(std::string_view name, std::span<const std::byte> bytes) {
    std::size_t at = signature.size();
    const auto fail = [&](const char* fault) { throw Error(name, fault, "byte " + std::to_string(at)); };
    if (!is_png(bytes)) throw Error(name, "is not a PNG file");
    std::string type;
    while (type != "IEND") {
        if (bytes.size() - at < frame_bytes) fail("is a PNG file that ends too early");
        const std::size_t length = big_endian(bytes, at);
        if (length > bytes.size() - at - frame_bytes) fail("is a PNG file with a chunk that ends after the file");
        const bool first = type.empty();
        type.assign(reinterpret_cast<const char*>(bytes.data()) + at + 4, 4);
        if (first && (type != "IHDR" || length != 13)) fail("is a PNG file without a header");
        const auto* checked = reinterpret_cast<const Bytef*>(bytes.data()) + at + 4;
        if (crc32_z(0, checked, length + 4) != big_endian(bytes, at + 8 + length))
            fail("is a damaged PNG file: the checksum of a chunk is wrong");
        at += frame_bytes + length;
    }
}

} // namespace hachure::assets
