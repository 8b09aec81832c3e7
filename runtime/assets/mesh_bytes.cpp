#include <hachure/runtime/assets/extension.h>
#include <hachure/runtime/assets/mesh_bytes.h>
#include <hachure/runtime/error.h>

#include <zlib.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <string>
#include <system_error>

namespace hachure::assets {
namespace {

MeshBytes read_raw(const std::filesystem::path& file) {
    std::error_code error;
    const auto status = std::filesystem::status(file, error);
    if (status.type() == std::filesystem::file_type::not_found) throw Error(file.string(), "no such file");
    if (error) throw Error(file.string(), error.message());
    if (std::filesystem::is_directory(status)) throw Error(file.string(), "is a directory");
    if (!std::filesystem::is_regular_file(status)) throw Error(file.string(), "is not a regular file");
    const std::uintmax_t size = std::filesystem::file_size(file, error);
    if (error) throw Error(file.string(), error.message());
    if (size == 0) throw Error(file.string(), "the file is empty");
    if (size > max_mesh_bytes) throw Error(file.string(), "the file is larger than 2 GiB");

    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> stream(std::fopen(file.c_str(), "rb"), &std::fclose);
    if (!stream) throw Error(file.string(), std::strerror(errno));
    MeshBytes bytes{std::make_unique_for_overwrite<char[]>(size), size};
    if (std::fread(bytes.data.get(), 1, size, stream.get()) != size)
        throw Error(file.string(), "cannot be read to its end");
    return bytes;
}

/// A buffer that grows while it is filled, up to a bound.
class Growing {
public:
    Growing(std::size_t expected, std::size_t bound) : bound_(bound) {
        grow(std::clamp<std::size_t>(expected, 4096, bound));
    }
    [[nodiscard]] bool is_full() const { return used_ == bytes_.size; }
    [[nodiscard]] bool at_bound() const { return bytes_.size == bound_; }
    void grow() { grow(std::min(bound_, bytes_.size * 2)); }
    [[nodiscard]] char* free_space() const { return bytes_.data.get() + used_; }
    [[nodiscard]] std::size_t free_bytes() const { return bytes_.size - used_; }
    void add(std::size_t count) { used_ += count; }
    MeshBytes take() { return {std::move(bytes_.data), used_}; }

private:
    void grow(std::size_t size) {
        MeshBytes larger{std::make_unique_for_overwrite<char[]>(size), size};
        if (used_ > 0) std::memcpy(larger.data.get(), bytes_.data.get(), used_);
        bytes_ = std::move(larger);
    }
    std::size_t bound_;
    std::size_t used_ = 0;
    MeshBytes bytes_;
};

struct Inflater {
    Inflater() { ready = inflateInit2(&stream, 15 + 16) == Z_OK; } // 16: a gzip header
    ~Inflater() {
        if (ready) inflateEnd(&stream);
    }
    Inflater(const Inflater&) = delete;
    Inflater& operator=(const Inflater&) = delete;
    z_stream stream{};
    bool ready = false;
};

MeshBytes inflate_gzip(const std::filesystem::path& file, const MeshBytes& packed) {
    const std::size_t bound = std::min(max_mesh_bytes, std::max<std::size_t>(packed.size * max_inflation, 1 << 20));
    // The last four bytes hold the size modulo 2^32: a hint, that saves growing, and no more.
    std::uint32_t hint = 0;
    for (std::size_t i = 0; i < 4 && packed.size > 18; ++i)
        hint |= static_cast<std::uint32_t>(static_cast<unsigned char>(packed.data[packed.size - 4 + i])) << (8 * i);
    Growing out(std::min<std::size_t>(hint, packed.size * 16) + 1, bound);

    Inflater inflater;
    if (!inflater.ready) throw Error(file.string(), "cannot start to inflate");
    z_stream& z = inflater.stream;
    z.next_in = reinterpret_cast<Bytef*>(packed.data.get());
    z.avail_in = static_cast<uInt>(packed.size); // below 2 GiB
    for (;;) {
        if (out.is_full() && out.at_bound())
            throw Error(file.string(), "inflates to more than 64 times its size or 2 GiB");
        if (out.is_full()) out.grow();
        z.next_out = reinterpret_cast<Bytef*>(out.free_space());
        z.avail_out = static_cast<uInt>(out.free_bytes());
        const uInt before = z.avail_out;
        const int result = inflate(&z, Z_NO_FLUSH);
        out.add(before - z.avail_out);
        if (result == Z_STREAM_END) {
            if (z.avail_in == 0) break;
            if (*z.next_in != 0x1f) break; // padding
            inflateReset(&z);              // members may follow each other
        } else if (result == Z_BUF_ERROR && z.avail_in == 0) {
            throw Error(file.string(), "truncated gzip data");
        } else if (result != Z_OK && result != Z_BUF_ERROR) {
            throw Error(file.string(), "not sound gzip data", "byte " + std::to_string(packed.size - z.avail_in));
        }
    }
    MeshBytes bytes = out.take();
    if (bytes.size == 0) throw Error(file.string(), "the file is empty");
    return bytes;
}

} // namespace

MeshBytes read_mesh_bytes(const std::filesystem::path& file) {
    MeshBytes bytes = read_raw(file);
    return lower_extension(file) == ".gz" ? inflate_gzip(file, bytes) : std::move(bytes);
}

std::string mesh_extension(const std::filesystem::path& file) {
    const std::string extension = lower_extension(file);
    return extension == ".gz" ? lower_extension(file.stem()) : extension;
}

} // namespace hachure::assets
