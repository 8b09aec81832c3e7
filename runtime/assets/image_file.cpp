#include <hachure/runtime/assert.h>
#include <hachure/runtime/assets/atomic_file.h>
#include <hachure/runtime/assets/exr_pixels.h>
#include <hachure/runtime/assets/image_file.h>
#include <hachure/runtime/assets/image_input.h>
#include <hachure/runtime/assets/orientation.h>
#include <hachure/runtime/assets/png_check.h>
#include <hachure/runtime/error.h>

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <memory>

namespace hachure::assets {
namespace {

Image decode(OIIO::ImageInput& input, const std::string& name) {
    if (is_exr(input)) return read_exr_color(input, name);
    const OIIO::ImageSpec& spec = input.spec();
    check_image_shape(spec, name);
    const bool is_float = spec.format.is_floating_point();
    const int channels = std::min(spec.nchannels, 4);
    Image image = make_image(spec.width, spec.height, channels, is_float ? PixelType::f32 : PixelType::u8);
    const OIIO::TypeDesc type = is_float ? OIIO::TypeDesc::FLOAT : OIIO::TypeDesc::UINT8;
    if (!input.read_image(0, 0, 0, channels, type, image.pixels.data()))
        throw Error(name, "can't be decoded: " + image_fault(input.geterror(), name));
    return image;
}

std::vector<std::byte> encode(const char* format, const OIIO::ImageSpec& spec, const Image& image,
                              const std::filesystem::path& path) {
    std::vector<unsigned char> bytes;
    OIIO::Filesystem::IOVecOutput memory(bytes);
    const std::string name = std::string("memory.") + format;
    const auto output = OIIO::ImageOutput::create(name, &memory);
    if (!output) throw Error(path.string(), "can't be encoded: " + image_fault(OIIO::geterror(), name));
    const bool done =
        output->open(name, spec) && output->write_image(spec.format, image.pixels.data()) && output->close();
    if (!done) throw Error(path.string(), "can't be encoded: " + image_fault(output->geterror(), name));
    const auto* data = reinterpret_cast<const std::byte*>(bytes.data());
    return {data, data + bytes.size()};
}

} // namespace

Image read_image(const std::filesystem::path& path) {
    return decode(*open_image(path), path.string());
}

Image read_upright_image(const std::filesystem::path& path) {
    const int orientation = orientation_of(open_image(path)->spec());
    return turned(read_image(path), orientation);
}

ImageSize read_upright_size(const std::filesystem::path& path) {
    const auto input = open_image(path);
    const ImageSize size = image_size(*input, path.string());
    return lies_on_its_side(orientation_of(input->spec())) ? ImageSize{size.height, size.width} : size;
}

Image read_image_memory(std::string_view name, std::span<const std::byte> bytes) {
    const std::string subject(name);
    if (is_png(bytes)) check_png(name, bytes);
    OIIO::Filesystem::IOMemReader memory(const_cast<std::byte*>(bytes.data()), bytes.size());
    return decode(*open_image(subject, memory), subject);
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
