// How dark strokes are, and what stays as it is when the view moves.

#include <hachure/tests/support/gl_fixture.h>
#include <hachure/tests/support/shade_picture.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace hachure::test {
namespace {

constexpr glm::vec3 from_front{0.2f, 0.3f, 1.0f};
constexpr std::array suns{glm::vec3{0.6f, 0.7f, 0.5f}, glm::vec3{-0.8f, 0.3f, 0.4f}, glm::vec3{0.1f, -0.9f, 0.3f},
                          glm::vec3{0.9f, 0.1f, -0.2f}};

View view_from(const glm::vec3& towards, float distance, int pixels) {
    return shade_view(glm::normalize(towards) * distance, pixels, pixels);
}

double mean(const std::vector<float>& values) {
    double sum = 0.0;
    for (const float v : values) sum += v;
    return sum / static_cast<double>(values.size());
}

/// Mean and largest difference of two pictures.
struct Difference {
    double mean = 0.0, largest = 0.0;
};

Difference difference(const std::vector<float>& a, const std::vector<float>& b) {
    Difference result;
    for (std::size_t i = 0; i < a.size(); ++i) {
        const double off = std::abs(double{a[i]} - b[i]);
        result.mean += off / static_cast<double>(a.size());
        result.largest = std::max(result.largest, off);
    }
    return result;
}

/// Coverage of a unit sphere's pixels, sorted by the shade that they need.
class DarknessBySphere {
public:
    static constexpr int bins = 11;

    void add(const std::vector<float>& coverage, const View& view, const glm::vec3& sun) {
        const glm::vec3 eye(view.eye), light = glm::normalize(sun);
        const glm::mat3 world_from_view = glm::transpose(glm::mat3(view.view_from_world));
        for (int y = 0; y < view.height; ++y)
            for (int x = 0; x < view.width; ++x) {
                const glm::vec2 ndc((2.0f * static_cast<float>(x) + 1.0f) / static_cast<float>(view.width) - 1.0f,
                                    (2.0f * static_cast<float>(y) + 1.0f) / static_cast<float>(view.height) - 1.0f);
                const glm::vec3 sight =
                    glm::normalize(world_from_view * glm::vec3(ndc.x / view.clip_from_view[0][0],
                                                               ndc.y / view.clip_from_view[1][1], -1.0f));
                const float along = glm::dot(eye, sight), square = along * along - glm::dot(eye, eye) + 1.0f;
                if (square < 0.0f) continue;
                const glm::vec3 place = eye - (along + std::sqrt(square)) * sight;
                if (-glm::dot(place, sight) < 0.25f) continue; // the rim, where a pixel is many strokes wide
                const float needed = std::clamp(1.0f - std::max(0.0f, glm::dot(place, light)) / 0.85f, 0.0f, 1.0f);
                Bin& bin = bins_[static_cast<std::size_t>(needed * static_cast<float>(bins - 1) + 0.5f)];
                bin.needed += needed;
                bin.coverage += coverage[static_cast<std::size_t>(y * view.width + x)];
                bin.pixels += 1.0;
            }
    }

    /// The straight line through what bins have, by least squares, and what they are off it, over its rise.
    struct Fit {
        double slope = 0.0, offset = 0.0, worst = 0.0;
        bool rises = true;
    };
    [[nodiscard]] Fit fit() const {
        double sx = 0.0, sy = 0.0, sxx = 0.0, sxy = 0.0;
        for (const Bin& bin : bins_) {
            sx += bin.x() / bins;
            sy += bin.y() / bins;
            sxx += bin.x() * bin.x() / bins;
            sxy += bin.x() * bin.y() / bins;
        }
        Fit fit;
        fit.slope = (sxy - sx * sy) / (sxx - sx * sx);
        fit.offset = sy - fit.slope * sx;
        for (std::size_t i = 0; i < bins_.size(); ++i) {
            const double off = bins_[i].y() - fit.offset - fit.slope * bins_[i].x();
            fit.worst = std::max(fit.worst, std::abs(off) / fit.slope);
            if (i > 0 && bins_[i].y() <= bins_[i - 1].y()) fit.rises = false;
        }
        return fit;
    }

private:
    struct Bin {
        double needed = 0.0, coverage = 0.0, pixels = 0.0;
        [[nodiscard]] double x() const { return needed / pixels; }
        [[nodiscard]] double y() const { return coverage / pixels; }
    };
    std::array<Bin, bins> bins_{};
};

DarknessBySphere::Fit darkness_of_sphere(const ShadeStrokes& style, float distance = 3.6f) {
    ShadeRig rig(geometry::icosphere(1.0, 4), 4000);
    ShadePicture picture(rig);
    picture.style = style;
    DarknessBySphere darkness;
    for (const glm::vec3& sun : suns) {
        rig.update.reset();
        rig.step({shade_sun(sun)});
        picture.show(rig);
        const View view = view_from(from_front, distance, 500);
        darkness.add(picture.draw(view), view, sun);
    }
    return darkness.fit();
}

using ShadeDrawTest = GlTest;

/// The line's slope is no fit: it is what `full_darkness` and the opacity say.
TEST_P(ShadeDrawTest, DarknessIsLinearInShade) {
    for (const ShadeTip tip : {ShadeTip::pencil, ShadeTip::ink}) {
        ShadeStrokes style;
        style.tip = tip;
        const DarknessBySphere::Fit fit = darkness_of_sphere(style);
        const std::string name = tip == ShadeTip::pencil ? "pencil" : "ink";
        RecordProperty(name + "_worst", std::to_string(fit.worst));
        RecordProperty(name + "_slope", std::to_string(fit.slope));
        EXPECT_TRUE(fit.rises);
        EXPECT_LT(fit.worst, 0.05);
        EXPECT_NEAR(fit.offset, 0.0, 0.02);
        EXPECT_NEAR(fit.slope, double{full_darkness} * style.opacity, 0.1 * double{full_darkness} * style.opacity);
    }
}

TEST_P(ShadeDrawTest, CharcoalIsLinearToo) {
    ShadeStrokes style;
    style.tip = ShadeTip::charcoal;
    const DarknessBySphere::Fit fit = darkness_of_sphere(style);
    EXPECT_TRUE(fit.rises);
    EXPECT_LT(fit.worst, 0.05);
    EXPECT_NEAR(fit.slope, double{full_darkness} * style.opacity, 0.15 * double{full_darkness} * style.opacity);
}

/// From a quarter of a distance to four times as far: the same ink on the surface's part of the picture.
TEST_P(ShadeDrawTest, InkStaysOverDistance) {
    ShadeRig rig(geometry::icosphere(1.0, 4), 4000);
    rig.step({shade_sun({0.2f, 1.0f, 0.1f})});
    ShadePicture picture(rig);
    double least = 1.0, most = 0.0;
    for (const float distance : {2.0f, 4.0f, 8.0f, 16.0f, 32.0f}) {
        View frame = view_from(from_front, distance, static_cast<int>(1600.0f / distance));
        const float zoom = 0.95f * std::sqrt(distance * distance - 1.0f) / 3.0f; // so that the sphere fills the picture
        frame.clip_from_view[0][0] *= zoom;
        frame.clip_from_view[1][1] *= zoom;
        frame.clip_from_world = frame.clip_from_view * frame.view_from_world;
        frame.pixel_size /= zoom;
        const double ink = mean(picture.draw(frame));
        RecordProperty("ink" + std::to_string(static_cast<int>(distance)), std::to_string(ink));
        least = std::min(least, ink);
        most = std::max(most, ink);
    }
    EXPECT_GT(least, 0.1);
    EXPECT_LT(most, 1.2 * least); // within 10 % of their middle
}

/// Every segment of a plane that is seen straight on changes its level at the same distance. What changes over a step
/// of the way is the sum of what changes over its parts: a jump would be found in one of them.
TEST_P(ShadeDrawTest, NothingPopsWhenTheLevelChanges) {
    ShadeRig rig(geometry::plane(2.0, 8), 300);
    rig.step({shade_sun({1.0f, 0.35f, 0.0f})});
    ShadePicture picture(rig);
    const auto at = [&](double level) {
        const float distance = 7.0f * static_cast<float>(std::exp2(level));
        return picture.draw(shade_view({0.0f, distance, 1e-3f}, 300, 300));
    };
    constexpr int steps = 16, parts = 6; // over more than a level
    double largest = 0.0;
    int where = 0;
    for (int i = 0; i < steps; ++i) {
        const double step = difference(at(1.1 * i / steps), at(1.1 * (i + 1) / steps)).mean;
        if (step > largest) where = i;
        largest = std::max(largest, step);
    }
    EXPECT_GT(largest, 0.0);
    for (int i = 0; i < parts; ++i) {
        const double from = 1.1 * (where + double(i) / parts) / steps,
                     to = 1.1 * (where + double(i + 1) / parts) / steps;
        EXPECT_LT(difference(at(from), at(to)).mean, 0.4 * largest) << i;
    }
}

TEST_P(ShadeDrawTest, IntensityKeepsShade) {
    ShadeStrokes coarse, fine;
    coarse.intensity = 0.6f;
    fine.intensity = 1.8f;
    EXPECT_NEAR(darkness_of_sphere(coarse).slope, darkness_of_sphere(fine).slope, 0.05);
}

TEST_P(ShadeDrawTest, SameBitsAgain) {
    ShadeRig rig(geometry::torus(1.0, 0.4, 48, 24), 1500);
    rig.step_sun(40.0);
    ShadePicture first(rig), second(rig);
    const View view = view_from(from_front, 5.0f, 300), other = view_from({1.0f, 1.0f, 0.0f}, 4.0f, 300);
    const std::vector<float> picture = first.draw(view);
    second.draw(other);
    EXPECT_EQ(second.draw(view), picture);
    EXPECT_EQ(first.draw(view), picture);
}

/// Strokes on the far side of a body are behind it.
TEST_P(ShadeDrawTest, HiddenStrokesAreHidden) {
    ShadeRig rig(geometry::icosphere(1.0, 4), 2000);
    rig.step({shade_sun({0.0f, 0.0f, 1.0f})}); // its back is dark
    ShadePicture picture(rig);
    const View front = view_from({0.0f, 0.0f, 1.0f}, 5.0f, 400), back = view_from({0.0f, 0.0f, -1.0f}, 5.0f, 400);
    const std::vector<float> lit = picture.draw(front);
    double middle = 0.0; // within half the radius the light is above .85
    for (int y = 150; y < 250; ++y)
        for (int x = 150; x < 250; ++x) middle = std::max(middle, double{lit[static_cast<std::size_t>(y * 400 + x)]});
    EXPECT_LT(middle, 0.01); // strokes of its back cover up to 1
    EXPECT_GT(mean(picture.draw(back)), 3.0 * mean(lit));
}

/// A dark floor with a lid above it, as one mesh: the lid's four vertices are the last ones.
geometry::Shape floor_with_lid() {
    geometry::Shape shape = geometry::plane(2.0, 24);
    const auto first = static_cast<std::uint32_t>(shape.positions.size());
    for (const float z : {0.4f, -0.6f})
        for (const float x : {-0.6f, 0.1f}) {
            shape.positions.emplace_back(x, 0.3f, z);
            shape.normals.emplace_back(0.0f, 1.0f, 0.0f);
        }
    shape.indices.insert(shape.indices.end(), {first, first + 1, first + 2, first + 2, first + 1, first + 3});
    return shape;
}

/// The lid moves over the floor's strokes, a pixel in steps of a fiftieth: its edge, which is aligned with the
/// pixels, takes all samples of a row at once, and yet no more than a part of a stroke. With one sample a pixel that
/// would be three quarters.
TEST_P(ShadeDrawTest, AnEdgeThatPassesTakesStrokesInParts) {
    ShadeRig rig(floor_with_lid(), 1000);
    rig.step({shade_sun({0.0f, -1.0f, 0.0f})});
    ShadePicture picture(rig);
    const View view = view_from({0.0f, 1.0f, 0.01f}, 5.0f, 200);
    const float step = 0.02f * view.pixel_size * 4.7f;
    std::vector<glm::vec3> places = rig.shape().positions;
    std::vector<float> last = picture.draw(view);
    const std::vector<float> first = last;
    double most = 0.0;
    for (int i = 0; i < 50; ++i) {
        for (std::size_t v = places.size() - 4; v < places.size(); ++v) places[v].x += step;
        picture.deform(places);
        std::vector<float> now = picture.draw(view);
        most = std::max(most, difference(now, last).largest);
        last = std::move(now);
    }
    EXPECT_LT(most, 0.25);
    EXPECT_GT(difference(last, first).largest, 0.4) << "nothing was uncovered, or hidden";
}

TEST(FineSamples, FitIntoATexture) {
    EXPECT_EQ(fine_samples(640, 480), 4);
    EXPECT_EQ(fine_samples(1920, 1080), 4);
    EXPECT_EQ(fine_samples(2560, 1440), 3);
    EXPECT_EQ(fine_samples(3840, 2160), 2);
    EXPECT_EQ(fine_samples(8192, 100), 2);
    EXPECT_EQ(fine_samples(16384, 16), 1);
    EXPECT_EQ(fine_samples(16384, 16384), 1);
}

/// A turn of the camera by a tenth of a degree, all the way round: no picture differs from the next much more than the
/// others do, at silhouettes neither.
TEST_P(ShadeDrawTest, NothingPopsWhereSurfacesTurnAway) {
    ShadeRig rig(geometry::torus(1.0, 0.4, 48, 24), 1000);
    rig.step_sun(40.0);
    ShadePicture picture(rig);
    std::vector<double> steps;
    std::vector<float> last;
    for (int i = 0; i < 25; ++i) {
        const float angle = glm::radians(0.1f * static_cast<float>(i));
        const std::vector<float> now = picture.draw(view_from({std::sin(angle), 0.4f, std::cos(angle)}, 5.0f, 300));
        if (!last.empty()) steps.push_back(difference(now, last).mean);
        last = now;
    }
    std::ranges::sort(steps);
    EXPECT_LT(steps.back(), 1.5 * steps[steps.size() / 2]);
}

TEST_P(ShadeDrawTest, FlickerIsAFunctionOfItsTick) {
    ShadeRig rig(geometry::icosphere(1.0, 3), 1000);
    rig.step_sun(60.0);
    ShadePicture picture(rig);
    const View view = view_from(from_front, 4.0f, 300);
    const std::vector<float> still = picture.draw(view);
    picture.tick = 7;
    EXPECT_EQ(picture.draw(view), still); // there is no flicker
    picture.style.flicker = 0.3f;
    const std::vector<float> seventh = picture.draw(view);
    picture.tick = 8;
    const std::vector<float> eighth = picture.draw(view);
    picture.tick = 7;
    EXPECT_EQ(picture.draw(view), seventh);
    EXPECT_GT(difference(seventh, eighth).mean, 0.01);
    EXPECT_NEAR(mean(seventh), mean(eighth), 0.05 * mean(eighth));
    EXPECT_NEAR(mean(seventh), mean(still), 0.1 * mean(still));
}

TEST_P(ShadeDrawTest, DrawsNothingOfNoStrokes) {
    ShadeRig rig(geometry::icosphere(1.0, 2), 200);
    ShadePicture picture(rig); // no light was looked at yet
    EXPECT_EQ(mean(picture.draw(view_from(from_front, 4.0f, 100))), 0.0);
}

HACHURE_INSTANTIATE_GL_TESTS_ONCE(ShadeDrawTest);

} // namespace
} // namespace hachure::test
