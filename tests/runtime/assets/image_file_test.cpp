#include <hachure/runtime/assets/image_file.h>
#include <hachure/runtime/error.h>
#include <hachure/tests/support/temp_folder.h>

#include <gtest/gtest.h>
#include <OpenImageIO/imageio.h>

#include <cmath>
#include <cstring>
#include <limits>

namespace hachure::assets {
namespace {

using test::TempFolder;

Image noise_u8(int width, int height, int channels) {
    Image image = make_image(width, height, channels, PixelType::u8);
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
        image.u8()[i] = static_cast<std::uint8_t>((i * 2654435761u) >> 13);
    return image;
}

std::string image_fault(const std::filesystem::path& file) {
    try {
        static_cast<void>(read_image(file));
    } catch (const Error& error) {
        return error.what();
    }
    return {};
}

TEST(ImageFile, PngRoundTripIsExact) {
    const TempFolder folder;
    for (int channels = 1; channels <= 4; ++channels) {
        const Image image = noise_u8(37, 11, channels); // transparent, too
        write_png(folder / "i.png", image);
        const Image read = read_image(folder / "i.png");
        EXPECT_EQ(read.width, 37);
        EXPECT_EQ(read.height, 11);
        ASSERT_EQ(read.channels, channels);
        EXPECT_TRUE(read.pixels == image.pixels) << channels;
    }
}

TEST(ImageFile, SixteenBitsAreRoundedToEight) {
    const TempFolder folder;
    std::vector<std::uint16_t> values(4 * 256);
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<std::uint16_t>(i * 64 + i % 61);
    const std::string name = (folder / "i.png").string();
    const auto output = OIIO::ImageOutput::create(name);
    OIIO::ImageSpec spec(256, 1, 4, OIIO::TypeDesc::UINT16);
    spec.attribute("oiio:UnassociatedAlpha", 1);
    ASSERT_TRUE(output && output->open(name, spec));
    ASSERT_TRUE(output->write_image(OIIO::TypeDesc::UINT16, values.data()) && output->close());
    const Image read = read_image(name);
    ASSERT_EQ(read.type, PixelType::u8);
    ASSERT_EQ(read.channels, 4);
    for (std::size_t i = 0; i < values.size(); ++i) EXPECT_NEAR(read.u8()[i], values[i] / 257.0, 0.501) << i;
}

TEST(ImageFile, ExrRoundTripIsExact) {
    const TempFolder folder;
    Image image = make_image(19, 7, 3, PixelType::f32);
    for (std::size_t i = 0; i < image.pixels.size() / 4; ++i)
        image.f32()[i] = std::ldexp(std::sin(static_cast<float>(i)), static_cast<int>(i % 200) - 100);
    image.f32()[4] = std::numeric_limits<float>::infinity();
    write_exr(folder / "i.exr", image, std::vector<std::string>{"R", "G", "B"});
    const Image read = read_image(folder / "i.exr");
    ASSERT_EQ(read.type, PixelType::f32);
    ASSERT_EQ(read.channels, 3);
    EXPECT_TRUE(read.pixels == image.pixels);
}

/// OpenImageIO notes the time, to the second, unless it is told one.
TEST(ImageFile, ExrFilesDoNotSayWhenTheyWereWritten) {
    const TempFolder folder;
    const Image image = make_image(2, 2, 1, PixelType::f32);
    write_exr(folder / "i.exr", image, std::vector<std::string>{"Z"});
    EXPECT_NE(test::file_text(folder / "i.exr").find("1970:01:01 00:00:00"), std::string::npos);
}

TEST(ImageFile, MemoryReadsAsTheFileDoes) {
    const TempFolder folder;
    write_png(folder / "i.png", noise_u8(8, 8, 3));
    const std::string bytes = test::file_text(folder / "i.png");
    const Image image = read_image_memory("i.png", std::as_bytes(std::span(bytes.data(), bytes.size())));
    EXPECT_TRUE(image.pixels == read_image(folder / "i.png").pixels);
}

TEST(ImageFile, BrokenFilesAreRefusedByName) {
    const TempFolder folder;
    write_png(folder / "whole.png", noise_u8(64, 64, 3));
    const std::string whole = test::file_text(folder / "whole.png");
    for (std::size_t part = 0; part < 8; ++part) {
        const auto file = folder.write("cut.png", whole.substr(0, whole.size() * part / 8));
        EXPECT_TRUE(image_fault(file).starts_with(file.string() + ": ")) << part << ": " << image_fault(file);
    }
    EXPECT_TRUE(image_fault(folder / "absent.png").starts_with((folder / "absent.png").string() + ": "));
    EXPECT_TRUE(image_fault(folder.path()).starts_with(folder.path().string() + ": "));
}

/// A BMP header alone, which claims `side` x `side` pixels.
std::string bmp_header(std::int32_t side) {
    std::string bmp(54, '\0');
    const std::uint32_t offset = 54, header = 40;
    const std::uint16_t planes = 1, bits = 24;
    bmp[0] = 'B', bmp[1] = 'M';
    std::memcpy(bmp.data() + 10, &offset, 4);
    std::memcpy(bmp.data() + 14, &header, 4);
    std::memcpy(bmp.data() + 18, &side, 4);
    std::memcpy(bmp.data() + 22, &side, 4);
    std::memcpy(bmp.data() + 26, &planes, 2);
    std::memcpy(bmp.data() + 28, &bits, 2);
    return bmp;
}

TEST(ImageFile, HugeClaimsAreRefusedBeforeTheyCost) {
    const TempFolder folder;
    const auto file = folder.write("huge.bmp", bmp_header(60000));
    EXPECT_TRUE(image_fault(file).starts_with(file.string() + ": ")) << image_fault(file);
}

TEST(ImageFile, WritesNothingWhereItCannot) {
    const TempFolder folder;
    EXPECT_THROW(write_png(folder / "absent/i.png", noise_u8(2, 2, 3)), Error);
    EXPECT_TRUE(folder.listing().empty());
}

/// Of a stored image 3 x 2, a b c over d e f, what is to be seen for each of Exif's orientations.
TEST(ImageFile, PhotographsAreTurnedUpright) {
    const test::TempFolder folder;
    const std::string stored = "abcdef";
    const std::vector<std::string> seen{"abc/def",  "cba/fed",  "fed/cba",  "def/abc",
                                        "ad/be/cf", "da/eb/fc", "fc/eb/da", "cf/be/ad"};
    for (int orientation = 1; orientation <= 8; ++orientation) {
        const std::string file = (folder / "photo.tif").string();
        OIIO::ImageSpec spec(3, 2, 1, OIIO::TypeDesc::UINT8);
        spec.attribute("Orientation", orientation);
        const auto output = OIIO::ImageOutput::create(file);
        ASSERT_TRUE(output && output->open(file, spec) && output->write_image(spec.format, stored.data()) &&
                    output->close());
        const Image image = read_upright_image(file);
        std::string text;
        for (int i = 0; i < image.width * image.height; ++i) {
            if (i > 0 && i % image.width == 0) text += '/';
            text += static_cast<char>(image.u8()[i]);
        }
        EXPECT_EQ(text, seen[static_cast<std::size_t>(orientation - 1)]) << orientation;
        const ImageSize size = read_upright_size(file);
        EXPECT_EQ(size.width, image.width);
        EXPECT_EQ(size.height, image.height);
        EXPECT_EQ(read_image(file).width, 3) << "textures stay as they are";
    }
}

} // namespace
} // namespace hachure::assets
