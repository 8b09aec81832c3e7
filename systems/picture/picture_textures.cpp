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

void check_size(const gpu::Context& context, const PictureFile& file) {
    const int limit = context.limits().max_texture_size;
    if (file.width() > limit || file.height() > limit)
        throw Error(file.file(), fmt::format("is too large: {}x{}; this driver holds at most {} pixels a side",
                                             file.width(), file.height(), limit));
}

} // namespace

void PictureTextures::want(const PictureItem& item, bool color, bool tone) {
    Frame& frame = frames_[item.entity];
    frame.wants_color = color;
    frame.wants_tone = tone;
}

PictureTextures::Frame& PictureTextures::frame(const gpu::Context& context, PictureFile& file,
                                               const PictureItem& item) {
    Frame& frame = frames_[item.entity];
    if (frame.frame != item.frame || frame.file != file.file()) {
        frame.has_color = frame.has_tone = false;
        frame.frame = item.frame;
        frame.file = file.file();
    }
    const bool color = frame.wants_color && !frame.has_color, tone = frame.wants_tone && !frame.has_tone;
    if (!color && !tone) return frame;
    check_size(context, file);
    const assets::Image image = file.read(item.frame);
    if (color) upload_color(frame.color, image);
    if (tone) upload_tone(frame.tone, image);
    frame.has_color = frame.has_color || color;
    frame.has_tone = frame.has_tone || tone;
    return frame;
}

const gpu::Texture& PictureTextures::color(const gpu::Context& context, PictureFile& file, const PictureItem& item) {
    return frame(context, file, item).color;
}

const gpu::Texture& PictureTextures::tone(const gpu::Context& context, PictureFile& file, const PictureItem& item) {
    return frame(context, file, item).tone;
}

void PictureTextures::forget_all_but(const PictureList& list) {
    std::erase_if(frames_, [&](const auto& entry) {
        return std::ranges::find(list.items, entry.first, &PictureItem::entity) == list.items.end();
    });
}

} // namespace hachure
