#include <hachure/runtime/assets/frame_writer.h>
#include <hachure/runtime/assets/video_file.h>
#include <hachure/runtime/error.h>
#include <hachure/tests/support/given_models.h>
#include <hachure/tests/support/process.h>
#include <hachure/tests/support/temp_folder.h>

#include <gtest/gtest.h>

#include <vector>

#include "film_frames.h"

namespace hachure::assets {
namespace {

TEST(VideoFile, KnowsItsExtensions) {
    EXPECT_TRUE(is_video_name("a.mp4"));
    EXPECT_TRUE(is_video_name("A.MOV"));
    EXPECT_FALSE(is_video_name("a.png"));
    EXPECT_FALSE(is_video_name("mp4"));
}

TEST(VideoFile, RefusesWhatIsNone) {
    const test::TempFolder folder;
    EXPECT_THROW(VideoFile(folder / "absent.mp4"), Error);
    EXPECT_THROW(VideoFile(folder.path()), Error);
    EXPECT_THROW(VideoFile(folder.write("text.mp4", "not a video")), Error);
    EXPECT_THROW(VideoFile(folder.write("empty.mp4", "")), Error);
}

/// A film of frames that all differ, some of which the decoder needs others for that are shown later.
std::filesystem::path write_film(const test::TempFolder& folder, int frames, FrameRate rate) {
    const auto writer = make_frame_writer(folder / "film.mp4", {rate, {}});
    for (int i = 0; i < frames; ++i) writer->write(i, test::drawn_frame(96, 64, 2 * i));
    writer->finish();
    return folder / "film.mp4";
}

TEST(VideoFile, EveryFrameIsTheOneThatWasWritten) {
    const test::TempFolder folder;
    constexpr int frames = 40;
    VideoFile video(write_film(folder, frames, {24, 1}));
    ASSERT_EQ(video.frame_count(), frames);
    EXPECT_EQ(video.frame_rate(), (FrameRate{24, 1}));
    EXPECT_NEAR(video.duration(), frames / 24.0, 1e-6);
    std::vector<Image> in_order;
    for (int i = 0; i < frames; ++i) {
        in_order.push_back(video.read_frame(i));
        // Lossy: the next frame is this much farther away.
        EXPECT_LT(test::difference(in_order.back(), test::drawn_frame(96, 64, 2 * i)).rms, 6.0) << i;
        EXPECT_GT(test::difference(in_order.back(), test::drawn_frame(96, 64, 2 * i + 2)).rms, 9.0) << i;
    }
    for (const int i : {frames - 1, 0, frames - 2, 7, 7, 8, 30, 29, 1, frames - 1})
        EXPECT_TRUE(video.read_frame(i).pixels == in_order[static_cast<std::size_t>(i)].pixels) << i;
    VideoFile other(folder / "film.mp4");
    EXPECT_TRUE(other.read_frame(frames - 1).pixels == in_order.back().pixels) << "the first that is read";
}

TEST(VideoFile, ColoursComeBack) {
    const test::TempFolder folder;
    const auto writer = make_frame_writer(folder / "film.mp4", {{25, 1}, {}});
    const std::vector<Image> plain{test::plain_frame(32, 32, 200, 30, 60), test::plain_frame(32, 32, 20, 220, 40),
                                   test::plain_frame(32, 32, 10, 60, 230), test::plain_frame(32, 32, 255, 255, 255)};
    for (std::size_t i = 0; i < plain.size(); ++i) writer->write(static_cast<std::int64_t>(i), plain[i]);
    writer->finish();
    VideoFile video(folder / "film.mp4");
    for (std::size_t i = 0; i < plain.size(); ++i)
        EXPECT_LE(test::difference(video.read_frame(static_cast<int>(i)), plain[i]).largest, 3) << i;
}

TEST(VideoFile, AnimatedImagesAreVideos) {
    const test::TempFolder folder;
    const auto writer = make_frame_writer(folder / "a.gif", {{10, 1}, {}});
    const std::vector<Image> frames{test::plain_frame(20, 10, 200, 30, 60), test::plain_frame(20, 10, 20, 220, 40),
                                    test::plain_frame(20, 10, 10, 60, 230)};
    for (std::size_t i = 0; i < frames.size(); ++i) writer->write(static_cast<std::int64_t>(i), frames[i]);
    writer->finish();
    VideoFile video(folder / "a.gif");
    ASSERT_EQ(video.frame_count(), 3);
    for (const int i : {0, 1, 2, 0, 2})
        EXPECT_TRUE(video.read_frame(i).pixels == frames[static_cast<std::size_t>(i)].pixels) << i;
}

TEST(VideoFile, AMomentHasItsFrame) {
    const test::TempFolder folder;
    for (const FrameRate rate : {FrameRate{30000, 1001}, FrameRate{25, 2}, FrameRate{60, 1}}) {
        const VideoFile video(write_film(folder, 9, rate));
        for (int i = 0; i < 9; ++i) {
            EXPECT_EQ(video.frame_at(rate.time_of(i)), i);
            EXPECT_EQ(video.frame_at(rate.time_of(i) + 0.85 * rate.time_of(1)), i);
        }
        EXPECT_EQ(video.frame_at(-1e9), 0);
        EXPECT_EQ(video.frame_at(1e9), 8);
    }
}

TEST(VideoFile, WhatIsCutShortIsRefused) {
    const test::TempFolder folder;
    const std::string whole = test::file_text(write_film(folder, 30, {24, 1}));
    for (const std::size_t kept : {whole.size() / 2, whole.size() - 300, std::size_t{200}})
        EXPECT_THROW(VideoFile(folder.write("cut.mp4", whole.substr(0, kept))), Error) << kept;
    // Neither a playlist nor any other file that only looks like one.
    EXPECT_THROW(VideoFile(folder.write("list.mp4", "#EXTM3U\n#EXTINF:1,\nfilm.mp4\n")), Error);
    EXPECT_THROW(VideoFile(folder.write("concat.mp4", "ffconcat version 1.0\nfile film.mp4\n")), Error);
}

TEST(VideoFile, JumpsGiveTheFramesThatReadingInOrderGives) {
    const std::filesystem::path file = test::given_models() / "video" / "flower.mp4";
    if (!std::filesystem::exists(file)) GTEST_SKIP() << test::no_given_models << " with video/flower.mp4";
    VideoFile video(file);
    ASSERT_GE(video.frame_count(), 6);
    EXPECT_GT(video.frames_per_second(), 1.0);
    ASSERT_TRUE(video.frame_rate());
    EXPECT_DOUBLE_EQ(double(video.frame_rate()->frames) / video.frame_rate()->seconds, video.frames_per_second());
    std::vector<Image> frames;
    for (int i = 0; i < 6; ++i) frames.push_back(video.read_frame(i));
    EXPECT_EQ(frames[0].width, video.width());
    EXPECT_EQ(frames[0].height, video.height());
    EXPECT_EQ(frames[0].channels, 3);
    EXPECT_FALSE(frames[0].pixels == frames[5].pixels);
    for (const int i : {5, 0, 3})
        EXPECT_TRUE(video.read_frame(i).pixels == frames[static_cast<std::size_t>(i)].pixels) << i;
}

} // namespace
} // namespace hachure::assets
