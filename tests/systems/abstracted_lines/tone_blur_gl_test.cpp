// Kinds of blur against the blur in double precision.

#include <hachure/runtime/scene/render_context.h>
#include <hachure/systems/abstracted_lines/kawase_plan.h>
#include <hachure/systems/abstracted_lines/tone_blur.h>
#include <hachure/tests/support/gl_fixture.h>
#include <hachure/tests/support/line_images.h>
#include <hachure/tests/support/tone_ridge_reference.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

namespace hachure {
namespace {

using test::Tones;
using Kind = ToneBlur;

constexpr std::array kinds = {Kind::exact, Kind::separable, Kind::recursive, Kind::half, Kind::kawase};

const char* name_of(Kind kind) {
    constexpr std::array names = {"exact", "separable", "recursive", "half", "kawase"};
    return names[static_cast<std::size_t>(kind)];
}

/// Blurs pictures on the GPU. The second channel gets the picture upside down.
class Blurrer {
public:
    Blurrer(RenderContext& render, Kind kind, double sigma, int width, int height,
            gpu::Format format = gpu::Format::rg32f)
        : render_(render) {
        const gpu::TextureDesc desc{width, height, format};
        job_ = {.kind = kind,
                .sigma = sigma,
                .from = render.backend->create_texture(desc, "source"),
                .to = render.backend->create_texture(desc, "result"),
                .valid = {0, 0, width, height},
                .rect = {0, 0, width, height}};
        for (const gpu::TextureDesc& scratch : ToneBlurJob::scratch(kind, sigma, desc))
            scratch_.push_back(render.backend->create_texture(scratch, "scratch"));
    }

    ~Blurrer() {
        scratch_.insert(scratch_.end(), {job_.from, job_.to});
        for (const std::uint32_t id : scratch_) render_.backend->destroy_texture(id);
    }
    Blurrer(const Blurrer&) = delete;
    Blurrer& operator=(const Blurrer&) = delete;

    ToneBlurJob& job() { return job_; }

    Tones run(const Tones& tones, std::size_t channel = 0) {
        std::vector<float> pixels;
        for (int y = 0; y < tones.height; ++y)
            for (int x = 0; x < tones.width; ++x) {
                pixels.push_back(static_cast<float>(tones.at(x, y)));
                pixels.push_back(static_cast<float>(tones.at(x, tones.height - 1 - y)));
            }
        render_.backend->texture(job_.from).upload(std::span<const float>(pixels), gpu::RowOrder::bottom_first);
        job_.run(render_, scratch_);
        const std::vector<float> read = render_.backend->texture(job_.to).read_floats(gpu::RowOrder::bottom_first);
        Tones result(tones.width, tones.height);
        for (std::size_t i = 0; i < result.values.size(); ++i) result.values[i] = read[2 * i + channel];
        return result;
    }

private:
    RenderContext& render_;
    ToneBlurJob job_;
    std::vector<std::uint32_t> scratch_;
};

/// Of pixels at least `margin` from the border.
double most_difference(const Tones& a, const Tones& b, int margin = 0) {
    double most = 0.0;
    for (int y = margin; y < a.height - margin; ++y)
        for (int x = margin; x < a.width - margin; ++x) most = std::max(most, std::abs(a.at(x, y) - b.at(x, y)));
    return most;
}

/// A dark bar and a bright one, up to the borders.
Tones bars(int width, int height, double half_width) {
    const auto first = test::TrueLine::through_middle(width, height, 0.5, -0.2 * width);
    const auto second = test::TrueLine::through_middle(width, height, 1.9, 0.2 * width);
    Tones tones = test::draw_line(width, height, first, test::profile::Bar{half_width}, 0.5, -0.4);
    const Tones bright = test::draw_line(width, height, second, test::profile::Bar{half_width}, 0.0, 0.5);
    for (std::size_t i = 0; i < tones.values.size(); ++i) tones.values[i] += bright.values[i];
    return tones;
}

using ToneBlurTest = test::GlTest;

struct Bounds {
    double inside, border;
};

/// The exact blur ends at three deviations. The recursive one has flatter tails. A pyramid has phases; at the border it
/// goes on with its own coarse texels.
Bounds bounds(Kind kind) {
    switch (kind) {
    case Kind::exact:
    case Kind::separable:
        return {4e-3, 4e-3};
    case Kind::recursive:
        return {0.01, 0.01};
    case Kind::half:
        return {3e-3, 0.06};
    case Kind::kawase:
        return {0.025, 0.15};
    }
    return {};
}

TEST_P(ToneBlurTest, AllKindsAreNearTheGaussian) {
    RenderContext render(context());
    for (const double sigma : {1.5, 2.0, 4.0, 12.0}) // half resolution from 4 on, a quarter from 8 on
        for (const Kind kind : kinds) {
            const int margin = static_cast<int>(2.5 * sigma), width = 40 + 2 * margin, height = 31 + 2 * margin;
            const Tones picture = bars(width, height, sigma), expected = test::blurred(picture, sigma);
            const Tones made = Blurrer(render, kind, sigma, width, height).run(picture);
            EXPECT_LT(most_difference(made, expected, margin), bounds(kind).inside) << name_of(kind) << " " << sigma;
            EXPECT_LT(most_difference(made, expected), bounds(kind).border) << name_of(kind) << " " << sigma;
        }
}

TEST_P(ToneBlurTest, BothChannelsAreBlurredAlike) {
    RenderContext render(context());
    for (const Kind kind : kinds) {
        const Tones picture = bars(64, 64, 3.0);
        Tones turned = picture;
        for (int y = 0; y < 64; ++y)
            for (int x = 0; x < 64; ++x) turned.at(x, y) = picture.at(x, 63 - y);
        Blurrer blurrer(render, kind, 3.0, 64, 64);
        EXPECT_EQ(blurrer.run(picture, 1).values, blurrer.run(turned, 0).values) << name_of(kind);
    }
}

TEST_P(ToneBlurTest, AFlatToneStaysAsItIs) {
    RenderContext render(context());
    for (const gpu::Format format : {gpu::Format::rg8, gpu::Format::rg16, gpu::Format::rg16f, gpu::Format::rg32f})
        for (const Kind kind : kinds)
            for (const double tone : {0.0, 0.2, 1.0}) {
                const Tones flat(50, 33, tone);
                Blurrer blurrer(render, kind, 3.0, 50, 33, format);
                const double step = format == gpu::Format::rg8     ? 1.0 / 255.0
                                    : format == gpu::Format::rg32f ? 1e-5
                                                                   : 6e-4;
                EXPECT_LE(most_difference(blurrer.run(flat), flat), 1.01 * step) << name_of(kind) << " " << tone;
            }
}

/// Wide, recursive filters are where floats lose most: not in differences.
TEST_P(ToneBlurTest, AFlatToneStaysAsItIsHoweverWideTheBlur) {
    RenderContext render(context());
    for (const double sigma : {2.5, 12.0, 32.0}) {
        Tones flat(200, 150, 0.7);
        for (double& v : flat.values) v = static_cast<double>(static_cast<float>(v));
        EXPECT_EQ(Blurrer(render, Kind::recursive, sigma, 200, 150).run(flat).values, flat.values) << sigma;
    }
}

/// Passes are confined to the pixels that lines can be in: these come out as they would have anyway.
TEST_P(ToneBlurTest, AnAreaIsBlurredAsTheWhole) {
    RenderContext render(context());
    for (const Kind kind : kinds) {
        const Tones picture = bars(97, 80, 3.0);
        Blurrer blurrer(render, kind, 3.0, 97, 80);
        const Tones whole = blurrer.run(picture);
        (void)blurrer.run(Tones(97, 80, 0.3)); // what scratch textures hold must not matter
        const gpu::Rect area{21, 33, 40, 17};
        blurrer.job().rect = area;
        const Tones part = blurrer.run(picture);
        for (int y = area.y; y < area.y + area.height; ++y)
            for (int x = area.x; x < area.x + area.width; ++x)
                ASSERT_NEAR(part.at(x, y), whole.at(x, y), kind == Kind::recursive ? 5e-3 : 1e-6)
                    << name_of(kind) << " " << x << " " << y;
    }
}

TEST_P(ToneBlurTest, NothingIsDoneForAnEmptyArea) {
    RenderContext render(context());
    for (const Kind kind : kinds) {
        Blurrer blurrer(render, kind, 3.0, 32, 32);
        const Tones before = blurrer.run(Tones(32, 32, 0.25));
        blurrer.job().rect = {5, 5, 0, 3};
        const Tones after = blurrer.run(Tones(32, 32, 0.75));
        EXPECT_EQ(before.values, after.values) << name_of(kind);
    }
}

/// What lies outside of the valid part is not looked at: tones go on as at its rim.
TEST_P(ToneBlurTest, TonesGoOnBeyondTheValidPart) {
    RenderContext render(context());
    for (const Kind kind : kinds) {
        const gpu::Rect valid{10, 12, 60, 44};
        const Tones picture = bars(90, 70, 4.0);
        Tones extended = picture, spoilt = picture;
        for (int y = 0; y < 70; ++y)
            for (int x = 0; x < 90; ++x) {
                const int u = std::clamp(x, 10, 69), v = std::clamp(y, 12, 55);
                extended.at(x, y) = picture.at(u, v);
                if (u != x || v != y) spoilt.at(x, y) = 7.0;
            }
        Blurrer blurrer(render, kind, 4.0, 90, 70);
        const Tones expected = blurrer.run(extended);
        blurrer.job().valid = blurrer.job().rect = valid;
        const Tones made = blurrer.run(spoilt);
        for (int y = 12; y < 56; ++y)
            for (int x = 10; x < 70; ++x)
                ASSERT_NEAR(made.at(x, y), expected.at(x, y), bounds(kind).border)
                    << name_of(kind) << " " << x << " " << y;
    }
}

/// Moving a picture by whole pixels moves the result, bit for bit; in a pyramid by as many as its coarsest texel has.
TEST_P(ToneBlurTest, ShiftsWithThePicture) {
    RenderContext render(context());
    for (const Kind kind : kinds) {
        const Tones picture = bars(96, 96, 4.0);
        Blurrer blurrer(render, kind, 4.0, 96, 96);
        const int shift = kind == Kind::half ? 2 : kind == Kind::kawase ? 1 << kawase_plan(4.0).levels : 1;
        Tones moved = picture;
        for (int y = 0; y < 96; ++y)
            for (int x = 0; x < 96; ++x) moved.at(x, y) = picture.clamped(x - shift, y);
        const Tones a = blurrer.run(picture), b = blurrer.run(moved);
        for (int y = 32; y < 64; ++y)
            for (int x = 32; x < 64; ++x)
                ASSERT_NEAR(b.at(x, y), a.at(x - shift, y), kind == Kind::recursive ? 1e-5 : 1e-6)
                    << name_of(kind) << " " << x << " " << y;
    }
}

/// Where the ground around a shape is flat, its place is nothing that a recursive filter remembers.
TEST_P(ToneBlurTest, AShapeOnAFlatGroundShiftsBitForBit) {
    RenderContext render(context());
    for (const Kind kind : {Kind::separable, Kind::recursive})
        for (const double sigma : {1.5, 2.5, 7.0}) {
            const int rim = static_cast<int>(16.0 * sigma), size = 2 * rim + 24;
            Tones shape(size, size, 0.9), moved = shape;
            for (int y = rim; y < rim + 20; ++y)
                for (int x = rim; x < rim + 20; ++x) {
                    const double tone = 0.5 + 0.2 * test::normal_noise(3, static_cast<std::uint64_t>(y * size + x));
                    shape.at(x, y) = moved.at(x + 3, y - 2) = tone;
                }
            Blurrer blurrer(render, kind, sigma, size, size);
            const Tones a = blurrer.run(shape), b = blurrer.run(moved);
            for (int y = 0; y < size - 2; ++y)
                for (int x = 0; x < size - 3; ++x)
                    ASSERT_EQ(a.at(x, y + 2), b.at(x + 3, y)) << name_of(kind) << " " << sigma << " " << x << " " << y;
        }
}

/// The last steps of a stack, where widths are nearly one, are so small that a recursive filter has no poles for them.
TEST_P(ToneBlurTest, SmallStepsAreBlurredToo) {
    RenderContext render(context());
    const Tones picture = bars(48, 40, 3.0);
    for (const Kind kind : kinds)
        for (const double sigma : {0.1, 0.9})
            EXPECT_LT(most_difference(Blurrer(render, kind, sigma, 48, 40).run(picture), test::blurred(picture, sigma)),
                      0.01)
                << name_of(kind) << " " << sigma;
}

HACHURE_INSTANTIATE_GL_TESTS(ToneBlurTest);

} // namespace
} // namespace hachure
