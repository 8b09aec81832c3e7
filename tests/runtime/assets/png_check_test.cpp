#include <hachure/runtime/assets/image_file.h>
#include <hachure/runtime/assets/png_check.h>
#include <hachure/runtime/error.h>

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace hachure::assets {
namespace {

/// A small PNG as our own writer makes it.
std::vector<std::byte> sound_png() {
    const std::filesystem::path path =
        std::filesystem::temp_directory_path() / ("png_check_" + std::to_string(::getpid()) + ".png");
    Image image = make_image(7, 5, 3, PixelType::u8);
    for (std::size_t i = 0; i < image.pixels.size(); ++i) image.pixels[i] = static_cast<std::byte>(i * 37);
    write_png(path, image);
    std::ifstream file(path, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    std::filesystem::remove(path);
    const auto* data = reinterpret_cast<const std::byte*>(text.data());
    return {data, data + text.size()};
}

std::string fault_of(std::span<const std::byte> bytes) {
    try {
        static_cast<void>(read_image_memory("a.png", bytes));
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

TEST(PngCheck, ASoundFilePasses) {
    const std::vector<std::byte> png = sound_png();
    EXPECT_TRUE(is_png(png));
    EXPECT_NO_THROW(check_png("a.png", png));
    EXPECT_EQ(read_image_memory("a.png", png).width, 7);
}

TEST(PngCheck, EveryTruncationIsNamedByUsAlone) {
    const std::vector<std::byte> png = sound_png();
    testing::internal::CaptureStderr();
    for (std::size_t length = 8; length < png.size(); ++length)
        EXPECT_NE(fault_of(std::span(png).first(length)).find("a.png: is a PNG file"), std::string::npos) << length;
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST(PngCheck, EveryChangedByteIsNamedByUsAlone) {
    std::vector<std::byte> png = sound_png();
    testing::internal::CaptureStderr();
    for (std::size_t at = 8; at < png.size(); ++at) {
        png[at] ^= std::byte{0x20};
        EXPECT_NE(fault_of(png).find("a.png: is a "), std::string::npos) << at;
        png[at] ^= std::byte{0x20};
    }
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

} // namespace
} // namespace hachure::assets
