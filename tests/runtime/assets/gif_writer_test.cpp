#include <hachure/runtime/assets/frame_writer.h>
#include <hachure/tests/runtime/assets/film_frames.h>
#include <hachure/tests/runtime/assets/film_reader.h>
#include <hachure/tests/support/temp_folder.h>

#include <gtest/gtest.h>

namespace hachure::assets {
namespace {

using test::drawn_frame;
using test::Film;
using test::plain_frame;
using test::TempFolder;

Film round_trip(const std::vector<Image>& frames, FrameRate rate = {10, 1}) {
    const TempFolder folder;
    const auto writer = make_frame_writer(folder / "a.gif", {rate, {}});
    for (std::size_t i = 0; i < frames.size(); ++i) writer->write(static_cast<std::int64_t>(i), frames[i]);
    writer->finish();
    EXPECT_EQ(folder.listing(), std::set<std::string>{"a.gif"});
    return test::read_film(folder / "a.gif");
}

/// `count` colours, spread over the cube, in any order.
Image colorful_frame(int width, int height, std::uint32_t count) {
    Image image = make_image(width, height, 3, PixelType::u8);
    for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(width * height); ++i) {
        const std::uint32_t color = (i * 7919u % count) * 2654435761u >> 8;
        image.u8()[3 * i] = static_cast<std::uint8_t>(color >> 16);
        image.u8()[3 * i + 1] = static_cast<std::uint8_t>(color >> 8);
        image.u8()[3 * i + 2] = static_cast<std::uint8_t>(color);
    }
    return image;
}

/// Sizes and contents that meet every length of codes, full tables and blocks that end where the image does.
TEST(GifWriter, FewColorsComeBackExactly) {
    for (const std::uint32_t count : {1u, 2u, 3u, 4u, 5u, 16u, 17u, 128u, 255u})
        for (const auto& [width, height] : {std::pair{1, 1}, {2, 1}, {7, 5}, {64, 48}, {200, 150}}) {
            const Image image = colorful_frame(width, height, count);
            const Film film = round_trip({image});
            ASSERT_EQ(film.frames.size(), 1u);
            ASSERT_EQ(film.width, width);
            ASSERT_EQ(film.height, height);
            EXPECT_EQ(test::difference(film.frames[0].image, image).largest, 0)
                << count << " " << width << "x" << height;
        }
}

TEST(GifWriter, ImagesOfEveryLengthEndWhereTheyShould) {
    for (int width = 1; width < 700; width += 3) {
        const Image image = colorful_frame(width, 7, 200);
        EXPECT_EQ(test::difference(round_trip({image}).frames.at(0).image, image).largest, 0) << width;
    }
}

TEST(GifWriter, DrawingsComeBackNearly) {
    std::vector<Image> frames;
    for (int i = 0; i < 4; ++i) frames.push_back(drawn_frame(160, 120, 3 * i));
    const Film film = round_trip(frames);
    ASSERT_EQ(film.frames.size(), 4u);
    for (std::size_t i = 0; i < 4; ++i) {
        const test::Difference error = test::difference(film.frames[i].image, frames[i]);
        EXPECT_LT(error.rms, 2.0) << i;
        EXPECT_LE(error.largest, 16) << i;
    }
}

TEST(GifWriter, AnyColorsComeBackSomehow) {
    const Image image = colorful_frame(200, 200, 40000);
    EXPECT_LT(test::difference(round_trip({image}).frames.at(0).image, image).rms, 24.0); // 255 of the whole cube
}

TEST(GifWriter, WhatStandsStillStaysAsItIs) {
    // A few thousand colours stand still while others come and go beside them.
    std::vector<Image> frames;
    for (int i = 0; i < 3; ++i) {
        Image image = drawn_frame(120, 80, 0);
        for (int y = 0; y < 80; ++y)
            for (int x = 100; x < 120; ++x)
                test::set_pixel(image, x, y, static_cast<std::uint8_t>(80 * i + y),
                                static_cast<std::uint8_t>(9 * (x - 100)), 30);
        frames.push_back(std::move(image));
    }
    const Film film = round_trip(frames);
    ASSERT_EQ(film.frames.size(), 3u);
    for (std::size_t i = 1; i < 3; ++i)
        for (int y = 0; y < 80; ++y)
            EXPECT_TRUE(std::equal(film.frames[0].image.u8() + 360 * y, film.frames[0].image.u8() + 360 * y + 300,
                                   film.frames[i].image.u8() + 360 * y))
                << "frame " << i << ", row " << y;
}

TEST(GifWriter, FramesThatAreAllAlikeAreStillFrames) {
    const Image image = drawn_frame(60, 40, 0);
    const Film film = round_trip({image, image, image});
    ASSERT_EQ(film.frames.size(), 3u);
    EXPECT_EQ(film.frames[2].image.pixels, film.frames[0].image.pixels);
    EXPECT_NEAR(film.frames[2].begins, 0.2, 1e-9);
}

/// Hundredths of a second can't say 1/30 s; 3, 4, 3 of them do on average.
TEST(GifWriter, TimesDoNotDrift) {
    const std::vector<Image> frames(61, plain_frame(2, 2, 9, 9, 9));
    for (const FrameRate rate : {FrameRate{30, 1}, {24, 1}, {2997, 100}, {50, 1}, {1, 1}, {30000, 1001}}) {
        const Film film = round_trip(frames, rate);
        ASSERT_EQ(film.frames.size(), 61u);
        for (std::size_t i = 0; i < 61; ++i) {
            EXPECT_NEAR(film.frames[i].begins, rate.time_of(static_cast<int>(i)), 0.00501) << rate.frames << " " << i;
            EXPECT_GE(film.frames[i].lasts, 0.0199) << rate.frames << " " << i;
        }
    }
}

TEST(GifWriter, RepeatsForEver) {
    const TempFolder folder;
    const auto writer = make_frame_writer(folder / "a.gif", {});
    writer->write(0, plain_frame(4, 4, 1, 2, 3));
    writer->finish();
    const std::string bytes = test::file_text(folder / "a.gif");
    EXPECT_TRUE(bytes.starts_with("GIF89a"));
    EXPECT_NE(bytes.find(std::string("NETSCAPE2.0\3\1\0\0\0", 16)), bytes.npos);
    EXPECT_EQ(bytes.back(), ';');
}

TEST(GifWriter, SameFramesSameBytes) {
    const TempFolder folder;
    for (const char* name : {"a.gif", "b.gif"}) {
        const auto writer = make_frame_writer(folder / name, {});
        for (int i = 0; i < 3; ++i) writer->write(i, drawn_frame(100, 80, i));
        writer->finish();
    }
    EXPECT_TRUE(test::file_text(folder / "a.gif") == test::file_text(folder / "b.gif"));
}

} // namespace
} // namespace hachure::assets
