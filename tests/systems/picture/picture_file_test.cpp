#include <hachure/runtime/error.h>
#include <hachure/systems/picture/picture_file.h>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <limits>

#include "picture_scene.h"

namespace hachure::test {
namespace {

using testing::HasSubstr;

std::string fault_of(const std::function<void()>& what) {
    try {
        what();
    } catch (const Error& error) {
        return error.what();
    }
    return "none";
}

TEST(PictureFile, AnImageHasOneFrame) {
    const TempFolder folder;
    const assets::Image image = noise(5, 3, 3);
    assets::write_png(folder / "i.png", image);
    PictureFile file((folder / "i.png").string());
    EXPECT_EQ(file.width(), 5);
    EXPECT_EQ(file.height(), 3);
    for (const double seconds : {0.0, 3.0, 1e6}) EXPECT_EQ(file.frame_at({.loop = true}, seconds), 0);
    EXPECT_TRUE(file.read(0, {.color = true}).color->pixels == image.pixels);
}

TEST(PictureFile, AVideosFrameFollowsFromTheTime) {
    const TempFolder folder;
    for (const assets::FrameRate rate :
         {assets::FrameRate{30000, 1001}, assets::FrameRate{24, 1}, assets::FrameRate{25, 2}}) {
        PictureFile file(write_film(folder, 16, 8, 7, rate));
        for (int k = 0; k < 7; ++k) {
            EXPECT_EQ(file.frame_at({}, rate.time_of(k)), k) << "second k / rate is in frame k";
            EXPECT_EQ(file.frame_at({}, rate.time_of(k) + 0.8 * rate.time_of(1)), k);
            EXPECT_EQ(file.frame_at({.speed = 2}, 0.5 * rate.time_of(k)), k);
            EXPECT_EQ(file.frame_at({.loop = true}, rate.time_of(k + 21)), k);
        }
        EXPECT_EQ(file.frame_at({.time_offset = float(rate.time_of(3)) + 0.001f}, rate.time_of(2)), 5);
        EXPECT_EQ(file.frame_at({}, rate.time_of(7)), 6) << "the last one stays";
        EXPECT_EQ(file.frame_at({}, 1e7), 6);
        EXPECT_EQ(file.frame_at({.time_offset = -1e6f}, 1e5), 0) << "as does the first";
        EXPECT_EQ(file.frame_at({.speed = 0}, 1e5), 0);
        EXPECT_EQ(file.frame_at({.time_offset = float(-rate.time_of(2)) + 0.001f, .loop = true}, 0), 5);
    }
}

TEST(PictureFile, ANumberedImageFollowsFromTheTime) {
    const TempFolder folder;
    for (const int number : {10, 11, 14})
        assets::write_png(folder / fmt::format("i{}.png", number), noise(5, 3, 3));
    PictureFile file((folder / "i#.png").string());
    EXPECT_EQ(file.width(), 5);
    const int shown[] = {0, 1, 1, 1, 4};
    for (const float rate : {30.0f, 23.976f, 1.0f, 1000.0f})
        for (int k = 0; k < 5; ++k) {
            const double time = k / double(rate);
            EXPECT_EQ(file.frame_at({.frames_per_second = rate}, time), shown[k]) << rate << " " << k;
            EXPECT_EQ(file.frame_at({.frames_per_second = rate}, time + 0.8 / double(rate)), shown[k]);
            EXPECT_EQ(file.frame_at({.speed = 2, .frames_per_second = rate}, 0.5 * time), shown[k]);
            EXPECT_EQ(file.frame_at({.loop = true, .frames_per_second = rate}, time + 35.0 / double(rate)), shown[k]);
            EXPECT_EQ(file.frame_at({.frames_per_second = rate}, time + 1e7), 4) << "the last one stays";
            EXPECT_EQ(file.frame_at({.time_offset = -1e6f, .frames_per_second = rate}, time), 0) << "as does the first";
        }
}

TEST(PictureFile, FaultsNameTheFile) {
    const TempFolder folder;
    const auto opened = [&](const char* name) {
        return fault_of([&] { static_cast<void>(PictureFile((folder / name).string())); });
    };
    folder.write("text.png", "no picture");
    folder.write("text.mp4", "no film");
    for (const char* name : {"text.png", "text.mp4", "absent.png", "absent.mp4", "absent.#.png", "##.#.png"})
        EXPECT_THAT(opened(name), HasSubstr(std::string(name) + ": ")) << name;
    assets::Image image = assets::make_image(4, 3, 1, assets::PixelType::f32);
    image.f32()[6] = std::numeric_limits<float>::quiet_NaN();
    assets::write_exr(folder / "nan.exr", image, std::vector<std::string>{"Y"});
    PictureFile file((folder / "nan.exr").string());
    EXPECT_THAT(fault_of([&] { static_cast<void>(file.read(0, {.color = true})); }),
                HasSubstr("nan.exr: has values that are not finite (color, channel Y, column 2, row 1)"));
}

TEST(PictureFiles, FollowTheirEntity) {
    const TempFolder folder;
    assets::write_png(folder / "a.png", noise(5, 3, 3));
    assets::write_png(folder / "b.png", noise(6, 2, 3));
    PictureFiles files;
    World world;
    const Entity entity = world.create();
    const PictureFile* first = &files.open(entity, (folder / "a.png").string());
    EXPECT_EQ(first, &files.open(entity, (folder / "a.png").string()));
    EXPECT_EQ(files.open(entity, (folder / "b.png").string()).width(), 6);
}

} // namespace
} // namespace hachure::test
