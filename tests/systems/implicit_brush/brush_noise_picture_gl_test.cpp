#include <hachure/components/picture.h>
#include <hachure/runtime/assets/frame_writer.h>
#include <hachure/systems/implicit_brush/picture_phases.h>
#include <hachure/tests/support/gl_fixture.h>
#include <hachure/tests/support/temp_folder.h>
#include <hachure/tests/systems/implicit_brush/noise_measures.h>
#include <hachure/tests/systems/implicit_brush/wave_picture.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace hachure::test {
namespace {

constexpr Canvas canvas{160, 120};
constexpr int rate = 30;
constexpr glm::dvec2 wave_middle(80.0, 60.0);

/// Frame `frame` of a film that turns by 1.5 degrees a frame and comes nearer.
Origin film_origin(int frame) { return turned_about(wave_middle, 1.5 * frame, std::pow(1.01, frame)); }

/// From frame `darker_from` on with .73 of the tone: half the light.
void write_film(const std::filesystem::path& file, int frames, int darker_from = 1000) {
    const WavePicture picture;
    const auto writer = assets::make_frame_writer(file, {.rate = {rate, 1}, .channel_names = {}});
    for (int frame = 0; frame < frames; ++frame) {
        assets::Image image = assets::make_image(canvas.width, canvas.height, 3, assets::PixelType::u8);
        const Origin origin = film_origin(frame);
        for (int y = 0; y < canvas.height; ++y)
            for (int x = 0; x < canvas.width; ++x) {
                const double tone = picture.tone(origin({x + 0.5, y + 0.5})) * (frame < darker_from ? 1.0 : 0.73);
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

    /// How much of the noise's change motion does not explain, from each of 12 frames to the next; `last` is left.
    std::array<std::vector<double>, 2> play_film() {
        open(folder / "film.mp4");
        std::array<std::vector<double>, 2> changes;
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
                if (frame > 0) changes[i].push_back(moved_difference(now, last[i], velocity, middle_disk(now, 50.0)));
                last[i] = std::move(now);
            }
        }
        return changes;
    }

    static double root_mean_square(const std::vector<double>& values) {
        double sum = 0.0;
        for (const double v : values) sum += v * v;
        return std::sqrt(sum / static_cast<double>(values.size()));
    }

    std::array<NoiseImage, 2> last;
    TempFolder folder;
    gpu::Context* context = nullptr;
    std::unique_ptr<NoiseScene> scene;
    bool first = true;
};

TEST_F(BrushNoisePictureTest, HoldsToWhatMovesInAVideo) {
    write_film(folder / "film.mp4", 13);
    const std::array<std::vector<double>, 2> changes = play_film();
    const double still = root_mean_square(changes[screen]), moving = root_mean_square(changes[advected]);
    RecordProperty("screen", std::to_string(still));
    RecordProperty("advected", std::to_string(moving));
    EXPECT_LT(moving, still / 3.0);
    EXPECT_TRUE(statistics(last[advected]).in_range);
    EXPECT_NEAR(grain_size(last[advected], middle_disk(last[advected], 55.0)), 12.0, 3.0);
}

/// It neither jumps nor starts anew when the light is halved from one frame to the next.
TEST_F(BrushNoisePictureTest, HoldsThroughAJumpOfExposure) {
    constexpr std::size_t jump = 6;
    write_film(folder / "film.mp4", 13, jump);
    std::vector<double> changes = play_film()[advected];
    const double at_the_jump = changes[jump - 1];
    changes.erase(changes.begin() + (jump - 1));
    RecordProperty("at_the_jump", std::to_string(at_the_jump));
    RecordProperty("else", std::to_string(root_mean_square(changes)));
    EXPECT_LT(at_the_jump, 1.5 * *std::ranges::max_element(changes));
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
