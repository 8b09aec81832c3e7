#include <hachure/runtime/assets/yuv420.h>
#include <hachure/tests/runtime/assets/film_frames.h>

#include <gtest/gtest.h>

#include <array>
#include <vector>

namespace hachure::assets {
namespace {

struct Planes {
    std::vector<std::uint8_t> luma, blue, red;
};

Planes convert(const Image& image) {
    const auto wide = static_cast<std::size_t>(even_size(image.width)),
               high = static_cast<std::size_t>(even_size(image.height));
    Planes planes{std::vector<std::uint8_t>(wide * high), std::vector<std::uint8_t>(wide * high / 4),
                  std::vector<std::uint8_t>(wide * high / 4)};
    const ConvertToYuv420 job{.pixels = {image.u8(), image.pixels.size()},
                              .width = image.width,
                              .height = image.height,
                              .channels = image.channels,
                              .luma = {planes.luma, wide},
                              .blue = {planes.blue, wide / 2},
                              .red = {planes.red, wide / 2}};
    job.validate();
    job.run();
    return planes;
}

/// BT.709-6, items 3.2 to 3.5, of a colour in [0, 1].
std::array<double, 3> exact(double r, double g, double b) {
    const double y = 0.2126 * r + 0.7152 * g + 0.0722 * b;
    return {16 + 219 * y, 128 + 224 * (b - y) / 1.8556, 128 + 224 * (r - y) / 1.5748};
}

/// The colour at a pixel, or at the nearest one inside.
std::array<double, 3> color_at(const Image& image, int x, int y) {
    x = std::clamp(x, 0, image.width - 1), y = std::clamp(y, 0, image.height - 1);
    const std::uint8_t* p = image.u8() + (y * image.width + x) * image.channels;
    return {p[0] / 255.0, p[1] / 255.0, p[2] / 255.0};
}

TEST(Yuv420, IsWithinRoundingOfTheStandard) {
    for (const auto& [width, height] : {std::pair{16, 10}, {15, 9}, {1, 1}, {2, 7}}) {
        Image image = make_image(width, height, 3, PixelType::u8);
        for (std::size_t i = 0; i < image.pixels.size(); ++i) // black and white among it
            image.u8()[i] = static_cast<std::uint8_t>(std::clamp(int((i * 2654435761u) >> 22 & 511u) - 128, 0, 255));
        const Planes planes = convert(image);
        const int wide = even_size(width), high = even_size(height);
        for (int y = 0; y < high; ++y)
            for (int x = 0; x < wide; ++x) {
                const auto [r, g, b] = color_at(image, x, y);
                EXPECT_NEAR(planes.luma[y * wide + x], exact(r, g, b)[0], 0.51) << x << " " << y;
            }
        for (int y = 0; y < high / 2; ++y)
            for (int x = 0; x < wide / 2; ++x) {
                std::array<double, 3> mean{};
                for (int dy = 0; dy < 2; ++dy)
                    for (int dx = -1; dx <= 1; ++dx)
                        for (std::size_t c = 0; c < 3; ++c)
                            mean[c] += color_at(image, 2 * x + dx, 2 * y + dy)[c] * (dx == 0 ? 2 : 1) / 8;
                const auto wanted = exact(mean[0], mean[1], mean[2]);
                EXPECT_NEAR(planes.blue[y * wide / 2 + x], wanted[1], 0.51) << x << " " << y;
                EXPECT_NEAR(planes.red[y * wide / 2 + x], wanted[2], 0.51) << x << " " << y;
            }
    }
}

TEST(Yuv420, GreyHasNoColorAndKeepsItsOrder) {
    int last = 15;
    for (int grey = 0; grey < 256; ++grey) {
        const auto value = static_cast<std::uint8_t>(grey);
        const Planes planes = convert(test::plain_frame(2, 2, value, value, value));
        EXPECT_EQ(planes.blue[0], 128) << grey;
        EXPECT_EQ(planes.red[0], 128) << grey;
        EXPECT_GE(planes.luma[0], last) << grey;
        last = planes.luma[0];
    }
    EXPECT_EQ(last, 235);
}

TEST(Yuv420, AFourthChannelIsLeftOut) {
    const Image rgb = test::drawn_frame(12, 8, 0);
    Image rgba = make_image(12, 8, 4, PixelType::u8);
    for (std::size_t i = 0; i < 96; ++i) {
        std::copy_n(rgb.u8() + 3 * i, 3, rgba.u8() + 4 * i);
        rgba.u8()[4 * i + 3] = static_cast<std::uint8_t>(i);
    }
    const Planes a = convert(rgb), b = convert(rgba);
    EXPECT_EQ(a.luma, b.luma);
    EXPECT_EQ(a.blue, b.blue);
    EXPECT_EQ(a.red, b.red);
}

} // namespace
} // namespace hachure::assets
