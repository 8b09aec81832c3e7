#include <hachure/runtime/assets/exr_pixels.h>
#include <hachure/runtime/assets/image_input.h>
#include <hachure/runtime/assets/layered_image.h>
#include <hachure/runtime/assets/orientation.h>
#include <hachure/runtime/error.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace hachure::assets {
namespace {

constexpr double shortest_normal = 1e-4;

std::span<float> values_of(Image& image) { return {image.f32(), image.pixels.size() / sizeof(float)}; }

/// Throws for the first value that is `wrong`. Files that are no EXR have no names for channels.
template <class Wrong>
void refuse(Image& image, const std::string& file, const char* layer, std::span<const ImageChannel> channels,
            Wrong wrong) {
    const std::span<float> values = values_of(image);
    const auto found = std::ranges::find_if(values, wrong);
    if (found == values.end()) return;
    const auto at = found - values.begin(), pixel = at / image.channels;
    const auto channel = static_cast<std::size_t>(at % image.channels);
    const std::string name = channel < channels.size() ? channels[channel].name : std::to_string(channel + 1);
    throw Error(
        file, "has values that are not finite",
        fmt::format("{}, channel {}, column {}, row {}", layer, name, pixel % image.width, pixel / image.width));
}

bool is_not_finite(float value) { return !std::isfinite(value); }
bool is_nan(float value) { return std::isnan(value); }

void normalize(Image& image) {
    const std::span<float> values = values_of(image);
    for (std::size_t i = 0; i < values.size(); i += 3) {
        const double length = std::hypot(double(values[i]), double(values[i + 1]), double(values[i + 2]));
        for (std::size_t c = i; c < i + 3; ++c)
            values[c] = length < shortest_normal ? 0.0f : static_cast<float>(double(values[c]) / length);
    }
}

void mark_nothing(Image& image) {
    for (float& depth : values_of(image))
        if (!(depth > 0.0f && depth < far_depth)) depth = no_depth;
}

/// An image for a layer, which `reads` will fill.
Image& add_layer(std::optional<Image>& layer, ImageSize size, std::span<const ImageChannel> channels,
                 std::vector<ChannelRead>& reads) {
    layer = make_image(size.width, size.height, static_cast<int>(channels.size()), PixelType::f32);
    for (const ImageChannel& channel : channels)
        reads.push_back({channel, &*layer, static_cast<int>(&channel - channels.data())});
    return *layer;
}

LayeredImage read_exr_layers(OIIO::ImageInput& input, const std::string& name, WantedLayers wanted) {
    const ImageSize size = image_size(input, name);
    const ImageLayers layers = find_layers(exr_channels(input));
    LayeredImage result;
    std::vector<ChannelRead> reads;
    if (wanted.color) {
        add_layer(result.color, size, layers.color, reads);
        if (layers.color.empty()) result.color = make_image(size.width, size.height, 4, PixelType::f32);
    }
    if (wanted.normal && !layers.normal.empty()) add_layer(result.normal, size, layers.normal, reads);
    if (wanted.depth && !layers.depth.empty())
        std::ranges::fill(values_of(add_layer(result.depth, size, layers.depth, reads)), no_depth);
    read_exr(input, name, reads);
    if (result.color) refuse(*result.color, name, "color", layers.color, is_not_finite);
    if (result.normal) refuse(*result.normal, name, "normal", layers.normal, is_not_finite);
    if (result.depth) refuse(*result.depth, name, "depth", layers.depth, is_nan);
    if (result.normal) normalize(*result.normal);
    if (result.depth) mark_nothing(*result.depth);
    return result;
}

void turn(std::optional<Image>& layer, int orientation) {
    if (layer) layer = turned(std::move(*layer), orientation);
}

ImageLayers color_alone(const OIIO::ImageSpec& spec) {
    ImageLayers layers;
    for (int i = 0; i < std::min(spec.nchannels, 4); ++i)
        layers.color.push_back({0, i, spec.channelnames[static_cast<std::size_t>(i)]});
    return layers;
}

} // namespace

ImageInfo read_image_info(const std::filesystem::path& path) {
    const auto input = open_image(path);
    ImageInfo info{image_size(*input, path.string()), {}};
    if (lies_on_its_side(orientation_of(input->spec()))) std::swap(info.size.width, info.size.height);
    info.layers = is_exr(*input) ? find_layers(exr_channels(*input)) : color_alone(input->spec());
    return info;
}

LayeredImage read_layers(const std::filesystem::path& path, WantedLayers wanted) {
    const std::string name = path.string();
    const auto input = open_image(path);
    LayeredImage result;
    if (is_exr(*input)) {
        const int orientation = orientation_of(input->spec());
        result = read_exr_layers(*input, name, wanted);
        for (std::optional<Image>* layer : {&result.color, &result.normal, &result.depth}) turn(*layer, orientation);
    } else if (wanted.color) {
        result.color = read_upright_image(path);
        if (result.color->type == PixelType::f32)
            refuse(*result.color, name, "color", color_alone(input->spec()).color, is_not_finite);
    }
    return result;
}

} // namespace hachure::assets
