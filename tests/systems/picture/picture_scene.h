#pragma once

#include <hachure/components/compose.h>
#include <hachure/components/picture.h>
#include <hachure/components/picture_coat.h>
#include <hachure/runtime/assets/frame_writer.h>
#include <hachure/runtime/assets/image_file.h>
#include <hachure/systems/picture/picture.h>
#include <hachure/tests/support/drawn_scene.h>
#include <hachure/tests/support/temp_folder.h>

#include <cstdint>
#include <string>

namespace hachure::test {

/// An image in which every pixel is another.
inline assets::Image noise(int width, int height, int channels, std::uint32_t seed = 7) {
    assets::Image image = assets::make_image(width, height, channels, assets::PixelType::u8);
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        seed = seed * 1664525u + 1013904223u;
        image.u8()[i] = static_cast<std::uint8_t>(seed >> 24);
    }
    return image;
}

/// Frame `number` of a film for tests: grey, darker on the left, and lighter with every frame; compression changes it
/// little.
inline assets::Image film_frame(int width, int height, int number) {
    assets::Image image = assets::make_image(width, height, 3, assets::PixelType::u8);
    for (int i = 0; i < 3 * width * height; ++i)
        image.u8()[i] = static_cast<std::uint8_t>((i / 3 % width < width / 2 ? 20 : 60) + 16 * number);
    return image;
}

/// Writes a film of `frames` of them.
inline std::string write_film(const TempFolder& folder, int width, int height, int frames, assets::FrameRate rate) {
    const std::filesystem::path file = folder / "film.mp4";
    const auto writer = assets::make_frame_writer(file, {rate, {}});
    for (int i = 0; i < frames; ++i) writer->write(i, film_frame(width, height, i));
    writer->finish();
    return file.string();
}

/// A world that shows one picture.
class PictureScene : public DrawnScene {
public:
    PictureScene(gpu::Context& context, Canvas canvas)
        : DrawnScene(context, canvas), camera_(add(Camera{}, Transform{})) {}

    void set_background(const glm::vec3& color) { world().add(camera_, Compose{.background = color}); }

    Entity show(const Picture& picture, const PictureCoat& coat = {}) { return world().create_with(picture, coat); }

    /// The tones that others read, of a new frame.
    assets::Image tones() {
        renderer().request_aov("picture_tone");
        renderer().render_frame();
        return renderer().read_aov("picture_tone");
    }

private:
    Entity camera_;
};

} // namespace hachure::test
