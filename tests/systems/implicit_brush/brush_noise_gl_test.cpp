#include <hachure/runtime/geometry/shapes.h>
#include <hachure/tests/support/gl_fixture.h>
#include <hachure/tests/systems/implicit_brush/noise_measures.h>

#include <gtest/gtest.h>

#include <cmath>

namespace hachure::test {
namespace {

constexpr Canvas noise_canvas{384, 384};

struct BrushNoiseTest : ::testing::Test {
    void SetUp() override {
        std::string reason;
        context = GlContexts::use(gpu::Backend::egl, reason);
        if (!context) GTEST_SKIP() << "no EGL context: " << reason;
    }

    /// A view of a ball that is 1.8 m wide and fills it; 2 m are the view's height.
    NoiseScene& make(const std::vector<BrushNoiseKey>& keys, Canvas size = noise_canvas) {
        scene = std::make_unique<NoiseScene>(*context, size, keys);
        camera = scene->add(Camera{.projection = Projection::orthographic, .ymag = 1.0f}, {.translation = {0, 0, 5}});
        ball = scene->add(surface_mesh(geometry::icosphere(0.9, 5)));
        return *scene;
    }

    NoiseImage draw(std::size_t index = 0) {
        scene->renderer().render_frame();
        return scene->noise(index);
    }

    void zoom(double times) { scene->world().get_mutable<Camera>(camera).ymag = static_cast<float>(1.0 / times); }

    gpu::Context* context = nullptr;
    std::unique_ptr<NoiseScene> scene;
    Entity camera, ball;
};

void expect_even(const NoiseStatistics& found, const char* what) {
    EXPECT_TRUE(found.in_range) << what;
    for (std::size_t c = 0; c < 4; ++c) {
        EXPECT_NEAR(found.mean[c], 0.0, 0.05) << what << ' ' << c;
        EXPECT_NEAR(found.variance[c], 1.0 / 3.0, 0.03) << what << ' ' << c;
        for (std::size_t part = 0; part < 10; ++part)
            EXPECT_NEAR(found.histogram[c][part], 0.1, 0.02) << what << ' ' << c << ", tenth " << part;
    }
    EXPECT_LT(found.correlation, 0.06) << what;
}

TEST_F(BrushNoiseTest, ChannelsAreEvenAndIndependent) {
    make({{.grain = BrushGrain::screen, .size = 4.0f},
          {.grain = BrushGrain::solid, .size = 4.0f},
          {.grain = BrushGrain::advected, .size = 4.0f}});
    scene->renderer().render_frame();
    const NoiseImage screen = scene->noise(0), solid = scene->noise(1), advected = scene->noise(2);
    expect_even(statistics(screen), "screen");
    expect_even(statistics(solid, middle_disk(solid, 170.0)), "solid");
    expect_even(statistics(advected, middle_disk(advected, 170.0)), "advected");
}

/// Between octaves, too, where most noises of several octaves lose contrast.
TEST_F(BrushNoiseTest, KeepsItsContrastAtEveryDistance) {
    make({{.size = 4.0f}});
    for (double times = 1.0; times < 2.1; times *= 1.19) {
        zoom(times);
        const NoiseImage image = draw();
        const NoiseStatistics found = statistics(image, middle_disk(image, 150.0));
        for (const double variance : found.variance) EXPECT_NEAR(variance, 1.0 / 3.0, 0.025) << times;
    }
}

TEST_F(BrushNoiseTest, GrainsHaveTheSizeAskedFor) {
    for (const float size : {4.0f, 8.0f}) {
        make({{.grain = BrushGrain::screen, .size = size},
              {.grain = BrushGrain::solid, .size = size},
              {.grain = BrushGrain::advected, .size = size}});
        scene->renderer().render_frame();
        for (std::size_t i = 0; i < 3; ++i) {
            const NoiseImage image = scene->noise(i);
            EXPECT_NEAR(grain_size(image, middle_disk(image, 120.0)), size, 0.12 * size) << i;
        }
    }
}

TEST_F(BrushNoiseTest, SolidGrainsKeepTheirSizeOverAZoomOf16) {
    make({{.size = 5.0f}});
    double least = 1e9, most = 0.0;
    for (double times = 1.0; times <= 16.0; times *= 1.25) {
        zoom(times);
        const NoiseImage image = draw();
        const double size = grain_size(image, middle_disk(image, 120.0));
        least = std::min(least, size);
        most = std::max(most, size);
    }
    RecordProperty("least", std::to_string(least));
    RecordProperty("most", std::to_string(most));
    EXPECT_GT(least, 5.0 * 0.9);
    EXPECT_LT(most, 5.0 * 1.1);
}

/// The same by a camera that comes nearer, and in depth: a plane that recedes has grains of one size all over, across.
TEST_F(BrushNoiseTest, SolidGrainsKeepTheirSizeInDepth) {
    make({{.size = 5.0f}});
    scene->world().get_mutable<Camera>(camera) = {.yfov = 0.6f, .znear = 0.01f};
    scene->world().get_mutable<Surface>(ball).visible = false;
    const Entity wall = scene->add(surface_mesh(geometry::icosphere(40.0, 5)));
    for (const float distance : {1.0f, 4.0f, 16.0f}) {
        scene->world().get_mutable<Transform>(wall).translation = {0.0f, 0.0f, 5.0f - distance - 40.0f};
        const NoiseImage image = draw();
        EXPECT_NEAR(grain_size(image, middle_disk(image, 150.0)), 5.0, 0.5) << distance;
    }
}

TEST_F(BrushNoiseTest, WithoutFlatnessGrainsGrowWithTheSurface) {
    make({{.size = 3.0f, .flatness = 0.0f}, {.size = 3.0f, .flatness = 0.5f}});
    scene->renderer().render_frame();
    const auto size = [&](std::size_t index) {
        const NoiseImage image = scene->noise(index);
        return grain_size(image, middle_disk(image, 100.0));
    };
    const double solid = size(0), half = size(1);
    zoom(4.0);
    scene->renderer().render_frame();
    EXPECT_NEAR(size(0), 4.0 * solid, 0.6 * solid);
    EXPECT_NEAR(size(1), 2.0 * half, 0.3 * half);
}

TEST_F(BrushNoiseTest, GrainsInMetresAreOnesOfTheWorld) {
    make({{.size = 0.03f, .world_size = true},
          {.grain = BrushGrain::screen, .size = 0.03f, .world_size = true},
          {.grain = BrushGrain::advected, .size = 0.03f, .world_size = true}});
    for (const double times : {1.0, 2.0}) {
        zoom(times);
        scene->renderer().render_frame();
        const double expected = 0.03 * 192.0 * times;
        for (std::size_t i = 0; i < 3; ++i) {
            const NoiseImage image = scene->noise(i);
            EXPECT_NEAR(grain_size(image, middle_disk(image, 120.0)), expected, 0.15 * expected) << i;
        }
    }
}

/// Octaves come and go with the zoom at a finite rate: smaller steps have smaller changes.
TEST_F(BrushNoiseTest, DoesNotPopAsOneZooms) {
    make({{.size = 24.0f}}, {96, 96});
    const auto largest_change = [&](int steps) {
        double largest = 0.0;
        zoom(1.0);
        NoiseImage before = draw();
        for (int i = 1; i <= steps; ++i) {
            zoom(std::exp2(1.2 * i / steps));
            const NoiseImage now = draw();
            largest = std::max(largest, largest_difference(now, before));
            before = now;
        }
        return largest;
    };
    // In the middle of the ball alone: what the outline passes over changes at once.
    scene->world().get_mutable<Transform>(ball).scale = glm::vec3(4.0f);
    const double coarse = largest_change(40), fine = largest_change(80);
    EXPECT_LT(fine, 0.6 * coarse) << coarse;
}

TEST_F(BrushNoiseTest, SceneOfAnotherScaleLooksTheSame) {
    make({{.size = 6.0f}, {.size = 6.0f, .flatness = 0.3f}});
    scene->renderer().render_frame();
    const std::array before{scene->noise(0), scene->noise(1)};
    scene->world().get_mutable<Transform>(ball).scale = glm::vec3(1000.0f);
    scene->world().get_mutable<Transform>(camera).translation *= 1000.0f;
    auto& lens = scene->world().get_mutable<Camera>(camera);
    lens.ymag *= 1000.0f;
    lens.zfar *= 1000.0f;
    scene->renderer().render_frame();
    for (std::size_t i = 0; i < 2; ++i) {
        const NoiseImage now = scene->noise(i);
        EXPECT_LT(difference(now, before[i], middle_disk(now, 165.0)), 1e-3) << i;
    }
}

TEST_F(BrushNoiseTest, SeedsAndObjectsDiffer) {
    make({{.size = 4.0f, .seed = 1}, {.size = 4.0f, .seed = 2}});
    scene->world().get_mutable<Transform>(ball) = {.translation = {-0.5f, 0.0f, 0.0f}, .scale = glm::vec3(0.5f)};
    const std::uint32_t mesh = scene->world().get<Surface>(ball).mesh;
    scene->world().create_with(Transform{.translation = {0.5f, 0.0f, 0.0f}, .scale = glm::vec3(0.5f)}, Surface{mesh});
    scene->renderer().render_frame();
    const NoiseImage first = scene->noise(0), second = scene->noise(1);
    const double unrelated = std::sqrt(2.0 / 3.0);
    const PixelMask left = [](int x, int y) { return std::hypot(x - 95.5, y - 191.5) < 80.0; };
    EXPECT_NEAR(difference(first, second, left), unrelated, 0.05);
    NoiseImage right = first; // the other ball, moved to the left one's place
    for (int y = 0; y < right.height; ++y)
        for (int x = 0; x < right.width / 2; ++x)
            right.values[static_cast<std::size_t>(y * right.width + x)] = first.at(x + right.width / 2, y);
    EXPECT_NEAR(difference(first, right, left), unrelated, 0.05) << "two objects of one mesh";
}

TEST_F(BrushNoiseTest, CostsNothingWhileNothingChanges) {
    make({{.grain = BrushGrain::solid}, {.grain = BrushGrain::advected}, {.grain = BrushGrain::screen}});
    scene->renderer().render_frame(0.1);
    scene->renderer().render_frame(0.1);
    for (const gpu::PassStats& pass : scene->renderer().pass_stats())
        if (pass.name.starts_with("brush_")) {
            EXPECT_EQ(pass.state, gpu::PassState::reused) << pass.name;
        }
}

TEST_F(BrushNoiseTest, IsTheSameInAnotherRun) {
    const std::vector<BrushNoiseKey> keys{{.grain = BrushGrain::solid}, {.grain = BrushGrain::advected}};
    std::vector<NoiseImage> images;
    for (int run = 0; run < 2; ++run) {
        make(keys);
        scene->renderer().render_frame();
        images.push_back(scene->noise(0));
        images.push_back(scene->noise(1));
    }
    EXPECT_EQ(largest_difference(images[0], images[2]), 0.0);
    EXPECT_EQ(largest_difference(images[1], images[3]), 0.0);
}

TEST_F(BrushNoiseTest, FillsTheRectangleThatItIsAskedFor) {
    make({{.size = 6.0f}});
    const NoiseImage whole = draw();
    scene->rect = {100, 40, 60, 200};
    const NoiseImage part = draw();
    const PixelMask inside = [](int x, int y) { return x >= 100 && x < 160 && y >= 40 && y < 240; };
    EXPECT_EQ(difference(whole, part, inside), 0.0);
}

TEST_F(BrushNoiseTest, StaysFiniteWhereSurfacesAreDegenerate) {
    make({{.grain = BrushGrain::solid, .size = 0.001f},
          {.grain = BrushGrain::advected, .size = 0.001f},
          {.grain = BrushGrain::solid, .size = 0.001f, .world_size = true},
          {.grain = BrushGrain::solid, .size = 1000.0f, .flatness = 0.0f}});
    geometry::Shape point;
    point.positions.assign(3, glm::vec3(0.2f, 0.0f, 1.0f));
    point.normals.assign(3, glm::vec3(0, 0, 1));
    point.indices = {0, 1, 2};
    scene->add(surface_mesh(point));
    scene->add(surface_mesh(geometry::icosphere(0.5, 2)), {.scale = {1.0f, 1.0f, 0.0f}});
    scene->world().get_mutable<Transform>(ball).scale = glm::vec3(1e-18f);
    for (int frame = 0; frame < 3; ++frame) {
        scene->world().get_mutable<Transform>(ball).scale *= 1e9f;
        scene->renderer().render_frame();
        for (std::size_t i = 0; i < 4; ++i) EXPECT_TRUE(statistics(scene->noise(i)).in_range) << i;
    }
}

} // namespace
} // namespace hachure::test
