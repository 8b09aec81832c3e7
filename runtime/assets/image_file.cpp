#include <hachure/runtime/assert.h>
#include <hachure/runtime/assets/atomic_file.h>
#include <hachure/runtime/assets/file_bytes.h>
#include <hachure/runtime/assets/image_file.h>
#include <hachure/runtime/assets/png_check.h>
#include <hachure/runtime/error.h>

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <memory>

namespace hachure::assets {
namespace {

std::string first_line(std::string text) {
    const std::size_t end = text.find('\n');
    if (end != std::string::npos) text.resize(end);
    return text;
}

/// OpenImageIO puts the file's name before most of its faults; ours is printed already.
std::string fault_of(std::string message, const std::string& name) {
    message = first_line(std::move(message));
    const std::size_t at = message.find(name);
    if (at != std::string::npos) message.erase(at, name.size());
    return message.empty() ? "is not an image" : message;
}

/// Colours as the file has them: OpenImageIO multiplies those of PNG files by alpha unless told otherwise, which
/// darkens what textures show where alpha is low, and is lossy.
OIIO::ImageSpec keep_colors() {
    OIIO::ImageSpec config;
    config.attribute("oiio:UnassociatedAlpha", 1);
    return config;
}

void check_shape(const OIIO::ImageSpec& spec, const std::string& name) {
    if (spec.width < 1 || spec.height < 1 || spec.nchannels < 1) throw Error(name, "is not an image: it has no pixels");
    if (std::int64_t{spec.width} * spec.height > max_image_pixels || spec.depth > 1)
        throw Error(name, "is too large: " + std::to_string(spec.width) + "x" + std::to_string(spec.height));
}

Image decode(OIIO::ImageInput& input, const std::string& name) {
    const OIIO::ImageSpec& spec = input.spec();
    check_shape(spec, name);
    const bool is_float = spec.format.is_floating_point();
    const int channels = std::min(spec.nchannels, 4);
    Image image = make_image(spec.width, spec.height, channels, is_float ? PixelType::f32 : PixelType::u8);
    const OIIO::TypeDesc type = is_float ? OIIO::TypeDesc::FLOAT : OIIO::TypeDesc::UINT8;
    if (!input.read_image(0, 0, 0, channels, type, image.pixels.data()))
        throw Error(name, "can't be decoded: " + fault_of(input.geterror(), name));
    return image;
}

void check_file(const std::filesystem::path& path) {
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(path, ignored)) throw Error(path.string(), "is not a file that can be read");
}

std::unique_ptr<OIIO::ImageInput> open(const std::string& name) {
    const OIIO::ImageSpec config = keep_colors();
    auto input = OIIO::ImageInput::open(name, &config);
    if (!input) throw Error(name, fault_of(OIIO::geterror(), name));
    return input;
}

/// Exif's: 1 upright; 3 upside down; 2 and 4 mirrored; 5 to 8 on its side.
int orientation_of(const OIIO::ImageSpec& spec) {
    const int orientation = spec.get_int_attribute("Orientation", 1);
    return orientation >= 1 && orientation <= 8 ? orientation : 1;
}

bool lies_on_its_side(int orientation) { return orientation >= 5; }

Image turned(Image image, int orientation) {
    if (orientation == 1) return image;
    const bool side = lies_on_its_side(orientation);
    // Of the stored image, in the order of Exif's numbers: whether the last column and the last row are seen first.
    const bool right = orientation == 2 || orientation == 3 || orientation == 7 || orientation == 8;
    const bool below = orientation == 3 || orientation == 4 || orientation == 6 || orientation == 7;
    Image result = side ? make_image(image.height, image.width, image.channels, image.type)
                        : make_image(image.width, image.height, image.channels, image.type);
    const std::size_t bytes = static_cast<std::size_t>(image.channels) * image.bytes_per_channel();
    std::byte* out = result.pixels.data();
    for (int y = 0; y < result.height; ++y)
        for (int x = 0; x < result.width; ++x, out += bytes) {
            const int column = side ? y : x, row = side ? x : y;
            const auto from = static_cast<std::size_t>(below ? image.height - 1 - row : row) * image.row_bytes() +
                              static_cast<std::size_t>(right ? image.width - 1 - column : column) * bytes;
            std::copy_n(image.pixels.data() + from, bytes, out);
        }
    return result;
}

bool starts_as_png(const std::filesystem::path& path) {
    std::array<std::byte, 8> start{};
    std::ifstream file(path, std::ios::binary);
    file.read(reinterpret_cast<char*>(start.data()), start.size());
    return file && is_png(start);
}

std::vector<std::byte> encode(const char* format, const OIIO::ImageSpec& spec, const Image& image,
                              const std::filesystem::path& path) {
    std::vector<unsigned char> bytes;
    OIIO::Filesystem::IOVecOutput memory(bytes);
    const std::string name = std::string("memory.") + format;
    const auto output = OIIO::ImageOutput::create(name, &memory);
    if (!output) throw Error(path.string(), "can't be encoded: " + first_line(OIIO::geterror()));
    const bool done =
        output->open(name, spec) && output->write_image(spec.format, image.pixels.data()) && output->close();
    if (!done) throw Error(path.string(), "can't be encoded: " + first_line(output->geterror()));
    const auto* data = reinterpret_cast<const std::byte*>(bytes.data());
    return {data, data + bytes.size()};
}

} // namespace

Image read_image(const std::filesystem::path& path) {
    const std::string name = path.string();
    check_file(path);
    if (starts_as_png(path)) return read_image_memory(name, read_file_bytes(path));
    return decode(*open(name), name);
}

Image read_upright_image(const std::filesystem::path& path) {
    const std::string name = path.string();
    check_file(path);
    const int orientation = orientation_of(open(name)->spec());
    return turned(read_image(path), orientation);
}

ImageSize read_upright_size(const std::filesystem::path& path) {
    const std::string name = path.string();
    check_file(path);
    const auto input = open(name);
    check_shape(input->spec(), name);
    const ImageSize size{input->spec().width, input->spec().height};
    return lies_on_its_side(orientation_of(input->spec())) ? ImageSize{size.height, size.width} : size;
}

Image read_image_memory(std::string_view name, std::span<const std::byte> bytes) {
    const std::string subject(name);
    if (is_png(bytes)) check_png(name, bytes);
    OIIO::Filesystem::IOMemReader memory(const_cast<std::byte*>(bytes.data()), bytes.size());
    OIIO::ImageSpec config = keep_colors();
    // OpenImageIO 2.4 forgets the reader in its argument when there is a configuration, which can name it, too.
    OIIO::Filesystem::IOProxy* proxy = &memory;
    config.attribute("oiio:ioproxy", OIIO::TypeDesc::PTR, &proxy);
    const auto input = OIIO::ImageInput::open(subject, &config, &memory);
    if (!input) throw Error(subject, fault_of(OIIO::geterror(), subject));
    return decode(*input, subject);
}

void write_png(const std::filesystem::path& path, const Image& image) {
    HACHURE_ASSERT(image.type == PixelType::u8, "PNG files are written from 8-bit images");
    OIIO::ImageSpec spec(image.width, image.height, image.channels, OIIO::TypeDesc::UINT8);
    spec.attribute("oiio:ColorSpace", "sRGB");
    spec.attribute("oiio:UnassociatedAlpha", 1);
    // Level 2 costs a third of zlib's default time for about a tenth more bytes on line drawings.
    spec.attribute("png:compressionLevel", 2);
    write_file_atomically(path, encode("png", spec, image, path));
}

void write_exr(const std::filesystem::path& path, const Image& image, std::span<const std::string> channel_names) {
    HACHURE_ASSERT(image.type == PixelType::f32, "EXR files are written from float images");
    HACHURE_ASSERT(channel_names.size() == static_cast<std::size_t>(image.channels), "one name per channel");
    OIIO::ImageSpec spec(image.width, image.height, image.channels, OIIO::TypeDesc::FLOAT);
    spec.channelnames.assign(channel_names.begin(), channel_names.end());
    spec.attribute("compression", "zip");
    // OpenImageIO would say when it was: the same image would never be the same file again.
    spec.attribute("DateTime", "1970:01:01 00:00:00");
    write_file_atomically(path, encode("exr", spec, image, path));
}

} // namespace hachure::assets
