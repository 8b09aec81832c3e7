#include <hachure/runtime/assets/gltf_data_uri.h>
#include <hachure/runtime/assets/gltf_reader.h>
#include <hachure/runtime/assets/path_rules.h>
#include <hachure/runtime/error.h>

#include <fmt/format.h>
#include <tiny_gltf.h>

#include <algorithm>
#include <array>

namespace hachure::assets {
namespace {

template <std::size_t N> bool starts_with(std::span<const std::byte> bytes, const std::array<unsigned char, N>& magic) {
    return bytes.size() > N && std::equal(magic.begin(), magic.end(), bytes.begin(),
                                          [](unsigned char a, std::byte b) { return static_cast<std::byte>(a) == b; });
}

bool is_png_or_jpeg(std::span<const std::byte> bytes) {
    return starts_with(bytes, std::array<unsigned char, 8>{0x89, 'P', 'N', 'G', 0x0d, 0x0a, 0x1a, 0x0a}) ||
           starts_with(bytes, std::array<unsigned char, 3>{0xff, 0xd8, 0xff});
}

std::string image_name(const GltfImageSource& source, std::size_t index) {
    if (source.uri && !is_data_uri(*source.uri)) return percent_decode(*source.uri);
    return source.name.empty() ? fmt::format("image {}", index) : source.name;
}

// A picture that cannot be had costs a warning with its name, not the model.
std::optional<EncodedImage> read_image(const GltfReader& reader, std::size_t index) {
    const GltfImageSource& source = reader.document.images[index];
    const std::string where = fmt::format("/images/{}", index);
    EncodedImage image;
    image.name = image_name(source, index);
    std::span<const std::byte> bytes;
    try {
        bytes = source.uri ? reader.buffers.resource(*source.uri, where) : reader.buffers.view(source.buffer_view);
    } catch (const Error& error) {
        reader.warnings.add(fmt::format("an image is skipped: {}", error.what()));
        return std::nullopt;
    }
    if (!is_png_or_jpeg(bytes)) {
        reader.warnings.add(fmt::format("an image that is neither PNG nor JPEG is skipped: {}", image.name), where);
        return std::nullopt;
    }
    reader.accessors.spend_elements(bytes.size(), 1, where);
    image.bytes.assign(bytes.begin(), bytes.end());
    return image;
}

Wrap wrap_of(int mode) {
    switch (mode) {
    case TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE:
        return Wrap::clamp;
    case TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT:
        return Wrap::mirror;
    default:
        return Wrap::repeat;
    }
}

void read_sampler(const tinygltf::Sampler& sampler, Texture& texture) {
    texture.wrap_s = wrap_of(sampler.wrapS);
    texture.wrap_t = wrap_of(sampler.wrapT);
    if (sampler.magFilter == TINYGLTF_TEXTURE_FILTER_NEAREST) texture.magnify = Filter::nearest;
    switch (sampler.minFilter) {
    case TINYGLTF_TEXTURE_FILTER_NEAREST:
        texture.minify = Filter::nearest;
        texture.mipmaps = false;
        break;
    case TINYGLTF_TEXTURE_FILTER_LINEAR:
        texture.mipmaps = false;
        break;
    case TINYGLTF_TEXTURE_FILTER_NEAREST_MIPMAP_NEAREST:
    case TINYGLTF_TEXTURE_FILTER_NEAREST_MIPMAP_LINEAR:
        texture.minify = Filter::nearest;
        break;
    default:
        break;
    }
}

} // namespace

void read_textures(const GltfReader& reader, Model& model) {
    std::vector<std::int32_t> image_of_source(reader.document.images.size(), -1);
    for (std::size_t i = 0; i < reader.document.images.size(); ++i) {
        std::optional<EncodedImage> image = read_image(reader, i);
        if (!image) continue;
        image_of_source[i] = static_cast<std::int32_t>(model.images.size());
        model.images.push_back(std::move(*image));
    }
    for (std::size_t i = 0; i < reader.document.model->textures.size(); ++i) {
        const tinygltf::Texture& source = reader.document.model->textures[i];
        Texture texture;
        if (source.source >= 0)
            texture.image = image_of_source[static_cast<std::size_t>(source.source)];
        else
            reader.warnings.add("textures without a PNG or JPEG source are skipped", fmt::format("/textures/{}", i));
        if (source.sampler >= 0)
            read_sampler(reader.document.model->samplers[static_cast<std::size_t>(source.sampler)], texture);
        model.textures.push_back(texture);
    }
}

} // namespace hachure::assets
