#include <hachure/runtime/assets/frame_writer.h>
#include <hachure/runtime/assets/video_file.h>
#include <hachure/tests/runtime/assets/film_frames.h>
#include <hachure/tests/runtime/assets/film_reader.h>
#include <hachure/tests/support/temp_folder.h>

#include <gtest/gtest.h>

extern "C" {
#include <libavcodec/avcodec.h>
}

namespace hachure::assets {
namespace {

using test::drawn_frame;
using test::Film;
using test::plain_frame;
using test::TempFolder;

void write_film(const std::filesystem::path& file, FrameRate rate, const std::vector<Image>& frames) {
    const auto writer = make_frame_writer(file, {rate, {}});
    for (std::size_t i = 0; i < frames.size(); ++i) writer->write(static_cast<std::int64_t>(i), frames[i]);
    writer->finish();
}

std::vector<Image> drawn_frames(int width, int height, int count) {
    std::vector<Image> frames;
    for (int i = 0; i < count; ++i) frames.push_back(drawn_frame(width, height, 2 * i));
    return frames;
}

TEST(Mp4Writer, PlayersFindWhatTheyExpect) {
    const TempFolder folder;
    write_film(folder / "a.mp4", {25, 1}, drawn_frames(96, 64, 10));
    const Film film = test::read_film(folder / "a.mp4");
    EXPECT_EQ(film.codec, AV_CODEC_ID_H264);
    EXPECT_EQ(film.pixel_format, AV_PIX_FMT_YUV420P);
    EXPECT_EQ(film.width, 96);
    EXPECT_EQ(film.height, 64);
    EXPECT_EQ(film.matrix, AVCOL_SPC_BT709);
    EXPECT_EQ(film.primaries, AVCOL_PRI_BT709);
    EXPECT_EQ(film.curve, AVCOL_TRC_IEC61966_2_1);
    EXPECT_EQ(film.range, AVCOL_RANGE_MPEG);
    EXPECT_EQ(film.siting, AVCHROMA_LOC_LEFT);
    EXPECT_EQ(folder.listing(), std::set<std::string>{"a.mp4"});
}

/// The tags of the container, which some players read and no others.
TEST(Mp4Writer, ColorsAreTaggedInTheContainer) {
    const TempFolder folder;
    write_film(folder / "a.mp4", {25, 1}, drawn_frames(96, 64, 2));
    const std::string bytes = test::file_text(folder / "a.mp4");
    const std::size_t box = bytes.find("colrnclx");
    ASSERT_NE(box, bytes.npos);
    EXPECT_EQ(bytes.substr(box + 8, 7), std::string("\0\1\0\15\0\1\0", 7)); // BT.709, sRGB, BT.709, limited
}

TEST(Mp4Writer, SaysNothingOnStderr) {
    const TempFolder folder;
    testing::internal::CaptureStderr();
    write_film(folder / "a.mp4", {25, 1}, drawn_frames(96, 64, 3));
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST(Mp4Writer, TheIndexComesFirst) {
    const TempFolder folder;
    write_film(folder / "a.mp4", {25, 1}, drawn_frames(96, 64, 3));
    const std::string bytes = test::file_text(folder / "a.mp4");
    ASSERT_NE(bytes.find("moov"), bytes.npos);
    EXPECT_LT(bytes.find("moov"), bytes.find("mdat"));
}

TEST(Mp4Writer, FramesBeginWhereTheRateSays) {
    const TempFolder folder;
    for (const FrameRate rate : {FrameRate{30, 1}, {1, 1}, {2997, 100}, {30000, 1001}, {1000, 1}}) {
        write_film(folder / "a.mp4", rate, drawn_frames(64, 48, 7));
        const Film film = test::read_film(folder / "a.mp4");
        ASSERT_EQ(film.frames.size(), 7u);
        for (std::size_t i = 0; i < 7; ++i) EXPECT_NEAR(film.frames[i].begins, rate.time_of(static_cast<int>(i)), 1e-9);
        EXPECT_NEAR(film.duration, rate.time_of(7), 1.1e-3); // counted in milliseconds
    }
}

TEST(Mp4Writer, PlainColorsComeBack) {
    const TempFolder folder;
    const std::array<std::array<std::uint8_t, 3>, 8> colors{{{0, 0, 0},
                                                             {255, 255, 255},
                                                             {128, 128, 128},
                                                             {255, 0, 0},
                                                             {0, 255, 0},
                                                             {0, 0, 255},
                                                             {204, 102, 51},
                                                             {30, 60, 120}}};
    std::vector<Image> frames;
    for (const auto& [red, green, blue] : colors) frames.push_back(plain_frame(64, 48, red, green, blue));
    write_film(folder / "a.mp4", {10, 1}, frames);
    const Film film = test::read_film(folder / "a.mp4");
    ASSERT_EQ(film.frames.size(), frames.size());
    for (std::size_t i = 0; i < frames.size(); ++i)
        EXPECT_LE(test::difference(film.frames[i].image, frames[i]).largest, 4) << i;
}

TEST(Mp4Writer, DrawingsComeBack) {
    const TempFolder folder;
    const std::vector<Image> frames = drawn_frames(160, 120, 6);
    write_film(folder / "a.mp4", {30, 1}, frames);
    const Film film = test::read_film(folder / "a.mp4");
    ASSERT_EQ(film.frames.size(), frames.size());
    for (std::size_t i = 0; i < frames.size(); ++i)
        EXPECT_LT(test::difference(film.frames[i].image, frames[i]).rms, 6.0) << i;
    EXPECT_GT(test::difference(film.frames[0].image, frames[5]).rms, 12.0) << "frames that all look alike";
}

TEST(Mp4Writer, OddSizesGetAnEdgeMore) {
    const TempFolder folder;
    const Image gray = plain_frame(33, 17, 90, 90, 90);
    write_film(folder / "a.mp4", {30, 1}, {gray});
    const Film film = test::read_film(folder / "a.mp4");
    EXPECT_EQ(film.width, 34);
    EXPECT_EQ(film.height, 18);
    ASSERT_EQ(film.frames.size(), 1u);
    EXPECT_LE(test::difference(film.frames[0].image, plain_frame(34, 18, 90, 90, 90)).largest, 2);
}

TEST(Mp4Writer, TinyFilmsAreFilms) {
    const TempFolder folder;
    write_film(folder / "a.mp4", {30, 1}, {plain_frame(1, 1, 255, 255, 255)});
    EXPECT_EQ(test::read_film(folder / "a.mp4").frames.size(), 1u);
}

TEST(Mp4Writer, SameFramesSameBytes) {
    const TempFolder folder;
    for (const char* name : {"a.mp4", "b.mp4"}) write_film(folder / name, {30, 1}, drawn_frames(128, 96, 12));
    EXPECT_TRUE(test::file_text(folder / "a.mp4") == test::file_text(folder / "b.mp4"));
}

TEST(Mp4Writer, TheHouseReadsItsOwn) {
    const TempFolder folder;
    write_film(folder / "a.mp4", {24, 1}, drawn_frames(64, 48, 5));
    VideoFile video(folder / "a.mp4");
    EXPECT_EQ(video.width(), 64);
    EXPECT_EQ(video.height(), 48);
    EXPECT_EQ(video.frame_count(), 5);
    EXPECT_DOUBLE_EQ(video.frames_per_second(), 24.0);
}

} // namespace
} // namespace hachure::assets
