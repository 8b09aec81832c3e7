#include <hachure/components/picture.h>
#include <hachure/runtime/assets/frame_writer.h>
#include <hachure/systems/implicit_brush/picture_phases.h>
#include <hachure/tests/support/gl_fixture.h>
#include <hachure/tests/support/temp_folder.h>
#include <hachure/tests/systems/implicit_brush/noise_measures.h>
#include <hachure/tests/systems/implicit_brush/wave_picture.h>

#include <gtest/gtest.h>

#include <cmath>

namespace hachure::test {
namespace {

constexpr Canvas canvas{160, 120};
constexpr int rate = 30;
constexpr glm::dvec2 wave_middle(80.0, 60.0);

/// Frame `frame` of a film that turns by 1.5 degrees a frame and comes nearer.
Origin film_origin(int frame) { return turned_about(wave_middle, 1.5 * frame, std::pow(1.01, frame)); }

void write_film(const std::filesystem::path& file, int frames) {
    const WavePicture picture;
    const auto writer = assets::make_frame_writer(file, {.rate = {rate, 1}, .channel_names = {}});
    for (int frame = 0; frame < frames; ++frame) {
        assets::Image image = assets::make_image(canvas.width, canvas.height, 3, assets::PixelType::u8);
        const Origin origin = film_origin(frame);
        for (int y = 0; y < canvas.height; ++y)
            for (int x = 0; x < canvas.width; ++x) {
                const double tone = picture.tone(origin({x + 0.5, y + 0.5}));
                std::uint8_t* pixel = image.u8() + 3 * ((canvas.height - 1 - y) * canvas.width + x);
                std::fill_n(pixel, 3, static_cast<std::uint8_t>(std::lround(255.0 * std::clamp(tone, 0.0, 1.0))));
            }
        writer->write(frame, image);
    }
    writer->finish();
}

struct BrushNoisePictureTest : ::testing::Test {
    static constexpr std::size_t screen = 0, advected = 1;

    void SetUp() override {
        std::string reason;
        context = GlContexts::use(gpu::Backend::egl, reason);
        if (!context) GTEST_SKIP() << "no EGL context: " << reason;
    }

    void open(const std::filesystem::path& file) {
        scene = std::make_unique<NoiseScene>(
            *context, canvas,
            std::vector<BrushNoiseKey>{{.grain = BrushGrain::screen}, {.grain = BrushGrain::advected}});
        scene->add(Camera{}, {.translation = {0, 0, 5}});
        scene->world().create_with(Picture{.file = file.string(), .fit = PictureFit::stretch});
    }

    /// The frame after so many more of the film.
    void step(int frames) { scene->renderer().render_frame((frames + (first ? 0.25 : 0.0)) / rate), first = false; }

    TempFolder folder;
    gpu::Context* context = nullptr;
    std::unique_ptr<NoiseScene> scene;
    bool first = true;
};

TEST_F(BrushNoisePictureTest, HoldsToWhatMovesInAVideo) {
    write_film(folder / "film.mp4", 13);
    open(folder / "film.mp4");
    std::array<NoiseImage, 2> before;
    std::array<double, 2> sums{};
    for (int frame = 0; frame < 12; ++frame) {
        step(frame == 0 ? 0 : 1);
        NoiseImage velocity{canvas.width, canvas.height, {}};
        for (int y = 0; y < canvas.height; ++y)
            for (int x = 0; x < canvas.width; ++x) {
                const glm::dvec2 place(x + 0.5, y + 0.5);
                velocity.values.emplace_back(glm::vec2(place - turned_about(wave_middle, 1.5, 1.01)(place)), 0.0f,
                                             0.0f);
            }
        for (std::size_t i = 0; i < 2; ++i) {
            NoiseImage now = scene->noise(i);
            if (frame > 0) sums[i] += std::pow(moved_difference(now, before[i], velocity, middle_disk(now, 50.0)), 2);
            before[i] = std::move(now);
        }
    }
    const double still = std::sqrt(sums[screen] / 11.0), moving = std::sqrt(sums[advected] / 11.0);
    RecordProperty("screen", std::to_string(still));
    RecordProperty("advected", std::to_string(moving));
    EXPECT_LT(moving, still / 3.0);
    EXPECT_TRUE(statistics(before[advected]).in_range);
    EXPECT_NEAR(grain_size(before[advected], middle_disk(before[advected], 55.0)), 12.0, 3.0);
}

/// Frame k is frame k, also where a run begins with it; and where there was another one before.
TEST_F(BrushNoisePictureTest, FollowsFromTheVideoAlone) {
    write_film(folder / "film.mp4", 38);
    open(folder / "film.mp4");
    for (int frame = 0; frame <= 36; ++frame) step(frame == 0 ? 0 : 1);
    const NoiseImage stepped = scene->noise(advected);
    first = true;
    open(folder / "film.mp4");
    step(36);
    EXPECT_EQ(largest_difference(stepped, scene->noise(advected)), 0.0);
}

TEST_F(BrushNoisePictureTest, IsAtRestOnAStillPicture) {
    write_film(folder / "still.png", 1);
    open(folder / "still.png");
    step(0);
    const NoiseImage before = scene->noise(advected);
    step(30);
    EXPECT_EQ(largest_difference(before, scene->noise(advected)), 0.0);
    for (const gpu::PassStats& pass : scene->renderer().pass_stats())
        if (pass.name.starts_with("brush_")) {
            EXPECT_EQ(pass.state, gpu::PassState::reused) << pass.name;
        }
}

TEST(PhaseStart, IsTheLastFrameInWhichNoiseOfThePhaseWasMade) {
    EXPECT_EQ(phase_start(0, 32, 0), 0);
    EXPECT_EQ(phase_start(31, 32, 0), 0);
    EXPECT_EQ(phase_start(32, 32, 0), 32);
    EXPECT_EQ(phase_start(15, 32, 1), 0) << "not before the video";
    EXPECT_EQ(phase_start(16, 32, 1), 16);
    EXPECT_EQ(phase_start(50, 32, 1), 48);
}

} // namespace
} // namespace hachure::test
