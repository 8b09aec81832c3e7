#include <hachure/runtime/assets/gltf_container.h>
#include <hachure/runtime/error.h>

#include <fmt/format.h>

#include <cstdint>
#include <cstring>

namespace hachure::assets {
namespace {

// glTF 2.0, section 4.4: a header of 12 bytes, then chunks of length, type and data; all little-endian.
constexpr std::size_t container_header_bytes = 12;
constexpr std::size_t chunk_header_bytes = 8;
constexpr std::uint32_t chunk_json = 0x4E4F534A;
constexpr std::uint32_t chunk_bin = 0x004E4942;

std::uint32_t little_endian_u32(std::span<const std::byte> bytes, std::size_t offset) {
    std::uint32_t value = 0;
    for (std::size_t i = 4; i-- > 0;) value = value << 8 | std::to_integer<std::uint32_t>(bytes[offset + i]);
    return value;
}

std::string_view as_text(std::span<const std::byte> bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

struct Chunk {
    std::uint32_t type = 0;
    std::span<const std::byte> data;
};

class GlbReader {
public:
    GlbReader(std::span<const std::byte> bytes, const std::string& file, GltfWarnings& warnings)
        : bytes_(bytes), file_(file) {
        if (bytes_.size() < container_header_bytes) fail("ends inside the GLB header", bytes_.size());
        if (const auto version = little_endian_u32(bytes_, 4); version != 2)
            fail(fmt::format("is GLB version {}; version 2 is understood", version), 4);
        const std::uint32_t length = little_endian_u32(bytes_, 8);
        if (length > bytes_.size())
            fail(fmt::format("is truncated: its header promises {} bytes, it has {}", length, bytes_.size()), 8);
        if (length < bytes_.size()) warnings.add("bytes after the end of the GLB are skipped");
        bytes_ = bytes_.first(length);
    }

    [[nodiscard]] bool at_end() const { return offset_ >= bytes_.size(); }

    Chunk next() {
        if (bytes_.size() - offset_ < chunk_header_bytes) fail("ends inside a chunk header", offset_);
        const std::uint32_t length = little_endian_u32(bytes_, offset_);
        const std::uint32_t type = little_endian_u32(bytes_, offset_ + 4);
        const std::size_t start = offset_ + chunk_header_bytes;
        if (length > bytes_.size() - start) fail("has a chunk that ends beyond the file", offset_);
        offset_ = start + length;
        return {type, bytes_.subspan(start, length)};
    }

    [[noreturn]] void fail(std::string_view fault, std::size_t offset) const {
        throw Error(file_, fault, fmt::format("byte {}", offset));
    }

private:
    std::span<const std::byte> bytes_;
    const std::string& file_;
    std::size_t offset_ = container_header_bytes;
};

} // namespace

GltfChunks split_gltf(std::span<const std::byte> bytes, const std::string& file, GltfWarnings& warnings) {
    if (bytes.empty()) throw Error(file, "is empty");
    if (bytes.size() < 4 || std::memcmp(bytes.data(), "glTF", 4) != 0) return {as_text(bytes), std::nullopt};

    GlbReader reader(bytes, file, warnings);
    if (reader.at_end()) reader.fail("has no JSON chunk", container_header_bytes);
    const Chunk json = reader.next();
    if (json.type != chunk_json) reader.fail("has a first chunk that is not JSON", container_header_bytes);
    GltfChunks chunks{as_text(json.data), std::nullopt};
    for (bool second = true; !reader.at_end(); second = false) {
        const Chunk chunk = reader.next();
        if (second && chunk.type == chunk_bin)
            chunks.binary = chunk.data;
        else
            warnings.add("unknown GLB chunks are skipped");
    }
    return chunks;
}

} // namespace hachure::assets
