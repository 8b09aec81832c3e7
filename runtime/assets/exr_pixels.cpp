#include <hachure/runtime/assets/exr_pixels.h>
#include <hachure/runtime/assets/image_input.h>
#include <hachure/runtime/error.h>

#include <algorithm>
#include <cstdint>
#include <set>

namespace hachure::assets {
namespace {

/// Rows of a file that are decoded at once: as many as the largest blocks of OpenEXR's compressors have, or those of
/// one block of the others where these would be large.
constexpr std::size_t most_rows = 256, least_rows = 32, band_bytes = std::size_t{1} << 26;

/// The part's name, without the view that it ends with: "N" of "N.left".
std::string part_layer(const OIIO::ImageSpec& spec) {
    std::string part(spec.get_string_attribute("oiio:subimagename", spec.get_string_attribute("name")));
    const std::string view = "." + std::string(spec.get_string_attribute("view"));
    if (view.size() > 1 && part.ends_with(view)) part.resize(part.size() - view.size());
    return part;
}

/// The channels of one part that are read, next to each other as the file has them.
struct Part {
    OIIO::ImageSpec spec;
    int number = 0;
    int first = 0, end = 0; ///< channels [first, end)
    std::vector<const ChannelRead*> reads;

    [[nodiscard]] std::size_t pixel_bytes() const { return spec.pixel_bytes(first, end, true); }
    [[nodiscard]] std::size_t row_bytes() const { return pixel_bytes() * static_cast<std::size_t>(spec.width); }
};

Part find_part(OIIO::ImageInput& input, const std::string& name, int number, std::span<const ChannelRead> reads) {
    Part part{.spec = input.spec(number), .number = number, .first = 0, .end = 0, .reads = {}};
    check_image_shape(part.spec, name);
    const OIIO::ImageSpec main = input.spec(0);
    if (part.spec.full_x != main.full_x || part.spec.full_y != main.full_y || part.spec.full_width != main.full_width ||
        part.spec.full_height != main.full_height)
        throw Error(name, "has parts of different display windows");
    part.first = part.spec.nchannels;
    for (const ChannelRead& read : reads) {
        if (read.from.part != number) continue;
        part.reads.push_back(&read);
        part.first = std::min(part.first, read.from.index);
        part.end = std::max(part.end, read.from.index + 1);
    }
    return part;
}

/// The numbers themselves: OpenImageIO would map all that an integer holds to [0, 1].
void copy_integers(const std::byte* from, std::size_t step, int count, float* to, std::size_t channels) {
    for (int i = 0; i < count; ++i, from += step, to += channels) {
        std::uint32_t value = 0;
        std::copy_n(from, sizeof value, reinterpret_cast<std::byte*>(&value));
        *to = static_cast<float>(value);
    }
}

/// Of a row at `pixels`, the columns that the display window has.
void copy_channel(const Part& part, const ChannelRead& read, const std::byte* pixels, int row) {
    const OIIO::ImageSpec& spec = part.spec;
    const int left = std::max(spec.x, spec.full_x),
              right = std::min(spec.x + spec.width, spec.full_x + spec.full_width);
    if (left >= right) return;
    const OIIO::TypeDesc type = spec.channelformat(read.from.index);
    const auto channels = static_cast<std::size_t>(read.into->channels);
    const std::size_t pixel = static_cast<std::size_t>(row) * static_cast<std::size_t>(read.into->width) +
                              static_cast<std::size_t>(left - spec.full_x);
    float* to = read.into->f32() + pixel * channels + static_cast<std::size_t>(read.channel);
    const std::byte* from = pixels + part.pixel_bytes() * static_cast<std::size_t>(left - spec.x) +
                            spec.pixel_bytes(part.first, read.from.index, true);
    if (type == OIIO::TypeDesc::UINT32) return copy_integers(from, part.pixel_bytes(), right - left, to, channels);
    OIIO::convert_image(1, right - left, 1, 1, from, type, static_cast<OIIO::stride_t>(part.pixel_bytes()),
                        OIIO::AutoStride, OIIO::AutoStride, to, OIIO::TypeDesc::FLOAT,
                        static_cast<OIIO::stride_t>(channels * sizeof(float)), OIIO::AutoStride, OIIO::AutoStride);
}

/// Rows [y, end) of the file, as it stores them.
bool read_rows(OIIO::ImageInput& input, const Part& part, int y, int end, std::byte* pixels) {
    const OIIO::ImageSpec& spec = part.spec;
    if (spec.tile_width > 0)
        return input.read_tiles(part.number, 0, spec.x, spec.x + spec.width, y, end, 0, 1, part.first, part.end,
                                OIIO::TypeDesc::UNKNOWN, pixels);
    return input.read_scanlines(part.number, 0, y, end, 0, part.first, part.end, OIIO::TypeDesc::UNKNOWN, pixels);
}

void read_part(OIIO::ImageInput& input, const std::string& name, const Part& part) {
    const OIIO::ImageSpec& spec = part.spec;
    const auto rows = static_cast<int>(std::clamp(band_bytes / part.row_bytes(), least_rows, most_rows));
    const int step = spec.tile_width > 0 ? std::max(spec.tile_height, 1) : rows; // tiles are read whole
    std::vector<std::byte> pixels(part.row_bytes() * static_cast<std::size_t>(std::min(step, spec.height)));
    for (int y = spec.y; y < spec.y + spec.height; y += step) {
        const int end = std::min(y + step, spec.y + spec.height);
        if (!read_rows(input, part, y, end, pixels.data()))
            throw Error(name, "can't be decoded: " + image_fault(input.geterror(), name));
        for (int row = std::max(y, spec.full_y); row < std::min(end, spec.full_y + spec.full_height); ++row)
            for (const ChannelRead* read : part.reads)
                copy_channel(part, *read, pixels.data() + part.row_bytes() * static_cast<std::size_t>(row - y),
                             row - spec.full_y);
    }
}

} // namespace

std::vector<ImageChannel> exr_channels(OIIO::ImageInput& input) {
    std::vector<ImageChannel> channels;
    const bool several = input.spec(1).nchannels > 0;
    for (int part = 0; part == 0 || input.spec(part).nchannels > 0; ++part) {
        const OIIO::ImageSpec spec = input.spec(part);
        if (spec.deep) continue;
        const std::string layer = several ? part_layer(spec) : std::string();
        for (int i = 0; i < spec.nchannels; ++i) {
            const std::string& own = spec.channelnames[static_cast<std::size_t>(i)];
            const bool bare = own.find('.') == own.npos && !layer.empty();
            channels.push_back({part, i, bare ? layer + "." + own : own});
        }
    }
    static_cast<void>(input.geterror()); // what asking for one part too many leaves
    return channels;
}

void read_exr(OIIO::ImageInput& input, const std::string& name, std::span<const ChannelRead> reads) {
    std::set<int> parts;
    for (const ChannelRead& read : reads) parts.insert(read.from.part);
    for (const int part : parts) read_part(input, name, find_part(input, name, part, reads));
}

Image read_exr_color(OIIO::ImageInput& input, const std::string& name) {
    const ImageSize size = image_size(input, name);
    const std::vector<ImageChannel> all = exr_channels(input);
    std::vector<ImageChannel> channels = find_layers(all).color;
    if (channels.empty()) // all of them are normals or depth
        for (const ImageChannel& channel : all)
            if (channel.part == all.front().part && channels.size() < 4) channels.push_back(channel);
    Image image = make_image(size.width, size.height, static_cast<int>(channels.size()), PixelType::f32);
    std::vector<ChannelRead> reads;
    for (const ImageChannel& channel : channels) reads.push_back({channel, &image, static_cast<int>(reads.size())});
    read_exr(input, name, reads);
    return image;
}

} // namespace hachure::assets
