#include <hachure/runtime/error.h>
#include <hachure/systems/picture/picture_textures.h>
#include <hachure/systems/picture/tone.h>

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

namespace hachure {
namespace {

/// Makes `texture` one of that shape where it is another.
void shape(gpu::Texture& texture, int width, int height, gpu::Format format, const char* label) {
    const gpu::TextureDesc desc{width, height, format};
    if (!texture || texture.desc() != desc) texture = gpu::Texture(desc, label);
}

/// Opaque bytes stay bytes, which the texture unit decodes; all else is linear and multiplied by alpha.
void upload_color(gpu::Texture& texture, const assets::Image& image) {
    const bool opaque = image.channels == 1 || image.channels == 3;
    if (image.type == assets::PixelType::f32 || !opaque) {
        shape(texture, image.width, image.height, gpu::Format::rgba16f, "picture color");
        texture.upload(std::span<const float>(premultiplied_colors(image)));
        return;
    }
    const std::size_t pixels = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
    const auto channels = static_cast<std::size_t>(image.channels);
    std::vector<std::uint8_t> bytes(4 * pixels, 255);
    for (std::size_t i = 0; i < pixels; ++i)
        for (std::size_t c = 0; c < 3; ++c) bytes[4 * i + c] = image.u8()[i * channels + (channels == 3 ? c : 0)];
    shape(texture, image.width, image.height, gpu::Format::srgb8_alpha8, "picture color");
    texture.upload(std::span<const std::uint8_t>(bytes));
}

void upload_tone(gpu::Texture& texture, const assets::Image& image) {
    shape(texture, image.width, image.height, gpu::Format::r32f, "picture tone");
    texture.upload(std::span<const float>(picture_tones(image)));
}

/// Alpha says whether there is one.
void upload_normal(gpu::Texture& texture, const assets::Image& image) {
    const std::size_t pixels = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
    std::vector<float> values(4 * pixels);
    for (std::size_t i = 0; i < pixels; ++i) {
        const float* normal = image.f32() + 3 * i;
        std::copy_n(normal, 3, values.data() + 4 * i);
        values[4 * i + 3] = normal[0] != 0.0f || normal[1] != 0.0f || normal[2] != 0.0f ? 1.0f : 0.0f;
    }
    shape(texture, image.width, image.height, gpu::Format::rgba32f, "picture normal");
    texture.upload(std::span<const float>(values));
}

void upload_depth(gpu::Texture& texture, const assets::Image& image) {
    shape(texture, image.width, image.height, gpu::Format::r32f, "picture depth");
    texture.upload(std::span(image.f32(), image.pixels.size() / sizeof(float)));
}

void upload(gpu::Texture& texture, PictureLayer layer, const assets::LayeredImage& image) {
    switch (layer) {
    case PictureLayer::tone:
        return upload_tone(texture, *image.color);
    case PictureLayer::color:
        return upload_color(texture, *image.color);
    case PictureLayer::normal:
        return upload_normal(texture, *image.normal);
    case PictureLayer::depth:
        return upload_depth(texture, *image.depth);
    }
}

void check_size(const gpu::Context& context, const PictureFile& file) {
    const int limit = context.limits().max_texture_size;
    if (file.width() > limit || file.height() > limit)
        throw Error(file.file(), fmt::format("is too large: {}x{}; this driver holds at most {} pixels a side",
                                             file.width(), file.height(), limit));
}

constexpr std::size_t at(PictureLayer layer) { return static_cast<std::size_t>(layer); }

} // namespace

void PictureTextures::want(const PictureItem& item, const PictureLayers& layers) {
    frames_[item.entity].wanted = layers;
}

void PictureTextures::complete(Frame& frame, const gpu::Context& context, PictureFile& file, const PictureItem& item) {
    const PictureLayers there{true, true, file.has_normal(), file.has_depth()};
    PictureLayers missing{};
    for (std::size_t i = 0; i < missing.size(); ++i) missing[i] = frame.wanted[i] && there[i] && !frame.read[i];
    check_size(context, file);
    const assets::LayeredImage image =
        file.read(item.frame, {.color = missing[at(PictureLayer::tone)] || missing[at(PictureLayer::color)],
                               .normal = missing[at(PictureLayer::normal)],
                               .depth = missing[at(PictureLayer::depth)]});
    for (std::size_t i = 0; i < missing.size(); ++i) {
        if (!missing[i]) continue;
        upload(frame.textures[i], static_cast<PictureLayer>(i), image);
        frame.read[i] = true;
    }
}

const gpu::Texture& PictureTextures::texture(PictureLayer layer, const gpu::Context& context, PictureFile& file,
                                             const PictureItem& item) {
    Frame& frame = frames_[item.entity];
    if (frame.number != item.frame || frame.file != file.file()) {
        frame.read = {};
        frame.number = item.frame;
        frame.file = file.file();
    }
    if (!frame.read[at(layer)]) complete(frame, context, file, item);
    return frame.textures[at(layer)];
}

void PictureTextures::forget_all_but(const PictureList& list) {
    std::erase_if(frames_, [&](const auto& entry) {
        return std::ranges::find(list.items, entry.first, &PictureItem::entity) == list.items.end();
    });
}

} // namespace hachure
