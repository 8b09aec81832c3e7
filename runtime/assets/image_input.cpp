#include <hachure/runtime/assets/file_bytes.h>
#include <hachure/runtime/assets/image_input.h>
#include <hachure/runtime/assets/orientation.h>
#include <hachure/runtime/assets/png_check.h>
#include <hachure/runtime/error.h>

#include <OpenImageIO/filesystem.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <string_view>

namespace hachure::assets {
namespace {

OIIO::ImageSpec keep_colors() {
    OIIO::ImageSpec config;
    config.attribute("oiio:UnassociatedAlpha", 1);
    return config;
}

void check_area(std::int64_t width, std::int64_t height, const std::string& name) {
    if (width * height > max_image_pixels)
        throw Error(name, "is too large: " + std::to_string(width) + "x" + std::to_string(height));
}

void check_image_file(const std::filesystem::path& path) {
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(path, ignored)) throw Error(path.string(), "is not a file that can be read");
}

bool starts_as_png(const std::filesystem::path& path) {
    std::array<std::byte, 8> start{};
    std::ifstream file(path, std::ios::binary);
    file.read(reinterpret_cast<char*>(start.data()), start.size());
    return file && is_png(start);
}

} // namespace

std::unique_ptr<OIIO::ImageInput> open_image(const std::filesystem::path& path) {
    check_image_file(path);
    if (starts_as_png(path)) check_png(path.string(), read_file_bytes(path));
    const OIIO::ImageSpec config = keep_colors();
    auto input = OIIO::ImageInput::open(path.string(), &config);
    if (!input) throw Error(path.string(), image_fault(OIIO::geterror(), path.string()));
    return input;
}

std::unique_ptr<OIIO::ImageInput> open_image(const std::string& name, OIIO::Filesystem::IOProxy& memory) {
    OIIO::ImageSpec config = keep_colors();
    // OpenImageIO 2.4 forgets the reader in its argument when there is a configuration, which can name it, too.
    OIIO::Filesystem::IOProxy* proxy = &memory;
    config.attribute("oiio:ioproxy", OIIO::TypeDesc::PTR, &proxy);
    auto input = OIIO::ImageInput::open(name, &config, &memory);
    if (!input) throw Error(name, image_fault(OIIO::geterror(), name));
    return input;
}

std::string image_fault(std::string message, const std::string& name) {
    message.resize(std::min(message.find('\n'), message.size()));
    const std::size_t at = message.find(name);
    if (at != std::string::npos) message.erase(at, name.size());
    return message.empty() ? "is not an image" : message;
}

void check_image_shape(const OIIO::ImageSpec& spec, const std::string& name) {
    if (spec.width < 1 || spec.height < 1 || spec.nchannels < 1) throw Error(name, "is not an image: it has no pixels");
    if (spec.deep) throw Error(name, "has deep pixels, which are not read: flatten it");
    if (spec.depth > 1) throw Error(name, "is a volume, not an image");
    check_area(spec.width, spec.height, name);
}

bool is_exr(const OIIO::ImageInput& input) { return std::string_view(input.format_name()) == "openexr"; }

ImageSize image_size(const OIIO::ImageInput& input, const std::string& name) {
    const OIIO::ImageSpec& spec = input.spec();
    check_image_shape(spec, name);
    if (!is_exr(input)) return {spec.width, spec.height};
    if (spec.full_width < 1 || spec.full_height < 1) throw Error(name, "is not an image: it has no pixels");
    check_area(spec.full_width, spec.full_height, name);
    return {spec.full_width, spec.full_height};
}

int orientation_of(const OIIO::ImageSpec& spec) { return orientation_from(spec.get_int_attribute("Orientation", 1)); }

} // namespace hachure::assets
