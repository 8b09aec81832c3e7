#pragma once

#include <hachure/runtime/assets/image_file.h>

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace hachure::test {

/// What a renderer writes of a pixel.
struct LayeredPixel {
    float color[3] = {0.5f, 0.5f, 0.5f};
    float normal[3] = {0.0f, 0.0f, 0.0f}; ///< 0: nothing is there
    float depth = 1e10f;                  ///< metres; 1e10: nothing is there
};

/// Writes an EXR with colour, normals and depth; `pixel(x, y)` counts from the upper left.
inline void write_layers(const std::filesystem::path& file, int width, int height,
                         const std::function<LayeredPixel(int x, int y)>& pixel) {
    assets::Image image = assets::make_image(width, height, 7, assets::PixelType::f32);
    float* to = image.f32();
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const LayeredPixel one = pixel(x, y);
            for (const float value : one.color) *to++ = value;
            for (const float value : one.normal) *to++ = value;
            *to++ = one.depth;
        }
    assets::write_exr(file, image, std::vector<std::string>{"R", "G", "B", "N.X", "N.Y", "N.Z", "Z"});
}

} // namespace hachure::test
