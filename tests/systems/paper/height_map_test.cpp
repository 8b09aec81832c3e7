#include <hachure/runtime/assets/image_file.h>
#include <hachure/runtime/error.h>
#include <hachure/runtime/parallel.h>
#include <hachure/systems/paper/grain.h>
#include <hachure/systems/paper/height_map.h>
#include <hachure/tests/support/temp_folder.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <string>

namespace hachure {
namespace {

using ::testing::HasSubstr;

constexpr PaperKind kinds[] = {PaperKind::tooth, PaperKind::cold_press, PaperKind::laid, PaperKind::canvas};
constexpr std::size_t side = grain_tile;

HeightMap sheet(PaperKind kind, float scale = 1.0f, std::uint32_t seed = 1) {
    return make_sheet({.kind = kind, .seed = seed, .scale = scale});
}

double height_at(const HeightMap& map, std::size_t x, std::size_t y) {
    return map.texels[y % side * side + x % side] / 255.0 - 0.5;
}

/// How alike heights are that lie (dx, dy) apart: 1 for the same, 0 for nothing in common.
double likeness(const HeightMap& map, std::size_t dx, std::size_t dy) {
    double product = 0.0, square = 0.0;
    for (std::size_t y = 0; y < side; ++y)
        for (std::size_t x = 0; x < side; ++x) {
            product += height_at(map, x, y) * height_at(map, x + dx, y + dy);
            square += height_at(map, x, y) * height_at(map, x, y);
        }
    return product / square;
}

TEST(HeightMapTest, EveryHeightIsAsFrequentAsAnyOther) {
    for (const PaperKind kind : kinds) {
        std::array<std::size_t, 256> counts{};
        for (const std::uint8_t texel : sheet(kind).texels) ++counts[texel];
        for (const std::size_t count : counts) EXPECT_EQ(count, side * side / 256) << int(kind);
    }
}

/// Between the last row and the first there is no larger step than between some other neighbours.
TEST(HeightMapTest, TilesCloseWithoutASeam) {
    for (const PaperKind kind : kinds) {
        const HeightMap map = sheet(kind, 1.7f);
        const auto step = [&](std::size_t at, bool rows) {
            double sum = 0.0;
            for (std::size_t i = 0; i < side; ++i)
                sum += rows ? std::abs(height_at(map, i, at) - height_at(map, i, at + 1))
                            : std::abs(height_at(map, at, i) - height_at(map, at + 1, i));
            return sum / side;
        };
        for (const bool rows : {false, true}) {
            double largest = 0.0;
            for (std::size_t at = 0; at + 1 < side; ++at) largest = std::max(largest, step(at, rows));
            EXPECT_LE(step(side - 1, rows), 1.02 * largest) << int(kind) << (rows ? " rows" : " columns");
        }
    }
}

/// Neighbours have something in common: pixels are fine enough for what the sheet holds.
TEST(HeightMapTest, HoldsNoDetailThatPixelsAreTooCoarseFor) {
    for (const PaperKind kind : kinds)
        for (const float scale : {0.5f, 1.0f, 4.0f}) {
            const HeightMap map = sheet(kind, scale);
            for (const auto& [dx, dy] : {std::pair<std::size_t, std::size_t>{1, 0}, {0, 1}}) {
                const double found = likeness(map, dx, dy);
                EXPECT_GT(found, scale < 1.0f ? 0.1 : 0.4) << int(kind) << " scale " << scale << " along " << dx << dy;
                RecordProperty(std::to_string(int(kind)) + (dx ? " x " : " y ") + std::to_string(scale),
                               std::to_string(found));
            }
        }
}

TEST(HeightMapTest, GrainDoesNotRepeatWithinTheTile) {
    for (const PaperKind kind : {PaperKind::tooth, PaperKind::cold_press}) {
        const HeightMap map = sheet(kind);
        for (const auto& [dx, dy] :
             {std::pair<std::size_t, std::size_t>{64, 0}, {128, 0}, {256, 0}, {512, 0}, {0, 512}, {512, 512}, {341, 0}})
            EXPECT_LT(std::abs(likeness(map, dx, dy)), 0.02) << int(kind) << " after " << dx << ", " << dy;
    }
}

/// A flat tone has no clouds: means over squares of 32 pixels are alike.
TEST(HeightMapTest, SheetsAreEven) {
    for (const PaperKind kind : kinds) {
        const HeightMap map = sheet(kind);
        double worst = 0.0;
        for (std::size_t top = 0; top < side; top += 32)
            for (std::size_t left = 0; left < side; left += 32) {
                double sum = 0.0;
                for (std::size_t i = 0; i < 32 * 32; ++i) sum += height_at(map, left + i % 32, top + i / 32);
                worst = std::max(worst, std::abs(sum / (32 * 32)));
            }
        EXPECT_LT(worst, 0.12) << int(kind);
        RecordProperty("kind " + std::to_string(int(kind)), std::to_string(worst));
    }
}

TEST(HeightMapTest, DependsOnKindScaleAndSeedAndNotOnThreads) {
    const int threads = thread_limit();
    for (const PaperKind kind : kinds) {
        const HeightMap map = sheet(kind);
        set_thread_limit(1);
        EXPECT_EQ(map.texels, sheet(kind).texels) << int(kind);
        set_thread_limit(threads);
        EXPECT_NE(map.texels, sheet(kind, 1.0f, 2).texels) << int(kind);
        EXPECT_NE(map.texels, sheet(kind, 2.0f).texels) << int(kind);
    }
    EXPECT_NE(sheet(PaperKind::laid).texels, sheet(PaperKind::canvas).texels);
}

/// Brighter texels lie higher, whatever the picture's curve.
TEST(HeightMapTest, HeightsOfAPictureAreInTheOrderOfItsBrightness) {
    assets::Image image = assets::make_image(16, 16, 1, assets::PixelType::u8);
    for (int i = 0; i < 256; ++i) image.u8()[i] = static_cast<std::uint8_t>(i * 167 % 256); // each value once
    const HeightMap map = picture_heights(image, 1.0f, "own.png");
    EXPECT_EQ(map.width, 16);
    EXPECT_EQ(map.height, 16);
    for (int i = 0; i < 256; ++i) EXPECT_EQ(map.texels[static_cast<std::size_t>(i)], image.u8()[i]) << i;
}

TEST(HeightMapTest, EqualHeightsAreToldApartEvenly) {
    assets::Image image = assets::make_image(64, 64, 3, assets::PixelType::u8);
    for (int i = 0; i < 64 * 64; ++i)
        for (int c = 0; c < 3; ++c) image.u8()[3 * i + c] = i % 2 ? 200 : 30;
    const HeightMap map = picture_heights(image, 1.0f, "own.png");
    std::array<int, 256> counts{};
    for (const std::uint8_t texel : map.texels) ++counts[texel];
    for (const int count : counts) EXPECT_EQ(count, 16);
    double upper_half = 0.0, lower_half = 0.0;
    for (std::size_t i = 0; i < map.texels.size(); ++i) (i < 2048 ? upper_half : lower_half) += map.texels[i];
    EXPECT_NEAR(upper_half / lower_half, 1.0, 0.03); // by lot and not by place
}

TEST(HeightMapTest, APictureIsScaledRoundItsEdges) {
    assets::Image image = assets::make_image(32, 8, 1, assets::PixelType::f32);
    for (int i = 0; i < 256; ++i) image.f32()[i] = std::sin(6.2831853f * (float(i % 32) + 0.5f) / 32.0f);
    const HeightMap twice = picture_heights(image, 2.0f, "own.exr"), half = picture_heights(image, 0.5f, "own.exr");
    EXPECT_EQ(twice.width, 64);
    EXPECT_EQ(twice.height, 16);
    EXPECT_EQ(half.width, 16);
    EXPECT_EQ(half.height, 4);
    for (int x = 0; x < 64; ++x) { // ranks of a sine are its phase
        const double height = std::asin(std::sin(6.2831853 * (x + 0.5) / 64.0)) / 3.14159265 + 0.5;
        EXPECT_NEAR(twice.texels[static_cast<std::size_t>(x)] / 255.0, height, 0.04) << x;
    }
}

TEST(HeightMapTest, FaultsNameTheFile) {
    const auto fault = [](const assets::Image& image, float scale) -> std::string {
        try {
            static_cast<void>(picture_heights(image, scale, "own.png"));
        } catch (const Error& error) {
            return error.what();
        }
        return "";
    };
    assets::Image image = assets::make_image(8, 8, 1, assets::PixelType::f32);
    EXPECT_THAT(fault(image, 1.0f), HasSubstr("own.png: is no paper: all its heights are the same"));
    image.f32()[3] = std::numeric_limits<float>::quiet_NaN();
    EXPECT_THAT(fault(image, 1.0f), HasSubstr("own.png: is no paper: it has heights that are not finite"));
    image.f32()[3] = std::numeric_limits<float>::infinity();
    EXPECT_THAT(fault(image, 1.0f), HasSubstr("not finite"));
    image.f32()[3] = 1.0f;
    EXPECT_EQ(fault(image, 1.0f), "");
    EXPECT_THAT(fault(assets::make_image(2000, 8, 1, assets::PixelType::u8), 4.0f), HasSubstr("own.png: is too large"));
    const test::TempFolder folder;
    const std::string missing = (folder / "none.png").string(),
                      broken = folder.write("broken.png", "no picture").string();
    for (const std::string& file : {missing, broken}) try {
            static_cast<void>(make_sheet({.file = file}));
            ADD_FAILURE() << file << " was read";
        } catch (const Error& error) {
            EXPECT_THAT(error.what(), HasSubstr(file));
        }
}

} // namespace
} // namespace hachure
