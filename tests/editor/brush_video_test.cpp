// A video in style `brush`, on the command line.

#include <hachure/runtime/assets/frame_writer.h>
#include <hachure/runtime/assets/video_file.h>
#include <hachure/tests/editor/program.h>

#include <cmath>

namespace hachure::test {
namespace {

constexpr int width = 160, height = 120, frames = 5, step = 10;
constexpr double radius = 30.0, middle_y = 60.0;

double middle_x(int frame) { return 50.0 + step * frame; }

/// A bright disc that moves to the right before a dark wall.
assets::Image disc_frame(int frame) {
    assets::Image image = assets::make_image(width, height, 3, assets::PixelType::u8);
    for (int i = 0; i < width * height; ++i) {
        const double d = std::hypot(i % width + 0.5 - middle_x(frame), i / width + 0.5 - middle_y);
        for (int c = 0; c < 3; ++c)
            image.u8()[3 * i + c] = static_cast<std::uint8_t>(60.0 + 140.0 / (1.0 + std::exp(2.0 * (d - radius))));
    }
    return image;
}

/// How dark the darkest pixel is within 3 pixels of a place.
int darkest(const assets::Image& image, double x, double y) {
    int result = 255;
    for (int j = -3; j <= 3; ++j)
        for (int i = -3; i <= 3; ++i) {
            const int at = (static_cast<int>(y) + j) * width + static_cast<int>(x) + i;
            result = std::min<int>(result, image.u8()[3 * at]);
        }
    return result;
}

TEST(BrushVideo, LinesFollowWhatMoves) {
    const TempFolder folder;
    const auto writer = assets::make_frame_writer(folder / "clip.mp4", {{25, 1}, {}});
    for (int i = 0; i < frames; ++i) writer->write(i, disc_frame(i));
    writer->finish();
    ASSERT_TRUE(succeeded(hachure_program(folder, {"render", "clip.mp4", "-o", "out.mp4", "--style", "brush"})));
    assets::VideoFile out(folder / "out.mp4");
    ASSERT_EQ(out.frame_count(), frames);
    EXPECT_EQ(out.frame_rate(), (assets::FrameRate{25, 1}));
    for (int frame = 0; frame < frames; ++frame) {
        const assets::Image image = out.read_frame(frame);
        ASSERT_EQ(image.width, width);
        for (double angle = 0.2; angle < 6.28; angle += 0.5)
            EXPECT_LT(darkest(image, middle_x(frame) + radius * std::cos(angle), middle_y + radius * std::sin(angle)),
                      90)
                << "frame " << frame << ", at " << angle << " rad of the edge";
        EXPECT_GT(darkest(image, middle_x(frame), middle_y), 150) << "nothing is drawn inside";
    }
}

} // namespace
} // namespace hachure::test
