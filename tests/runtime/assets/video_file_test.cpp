#include <hachure/runtime/assets/video_file.h>
#include <hachure/runtime/error.h>
#include <hachure/tests/support/given_models.h>
#include <hachure/tests/support/temp_folder.h>

#include <gtest/gtest.h>

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
