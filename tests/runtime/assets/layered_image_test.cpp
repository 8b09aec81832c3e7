#include <hachure/runtime/assets/image_file.h>
#include <hachure/runtime/assets/layered_image.h>
#include <hachure/runtime/error.h>
#include <hachure/tests/support/exr_file.h>
#include <hachure/tests/support/mutations.h>
#include <hachure/tests/support/temp_folder.h>

#include <gmock/gmock.h>

#include <cmath>
#include <functional>
#include <limits>

namespace hachure::assets {
namespace {

using test::ExrPart;
using test::TempFolder;
using test::write_exr_parts;
using testing::ElementsAre;
using testing::HasSubstr;

constexpr WantedLayers all{.color = true, .normal = true, .depth = true};
constexpr float infinity = std::numeric_limits<float>::infinity(), nan = std::numeric_limits<float>::quiet_NaN();
const std::vector<std::string> layered{"R", "G", "B", "A", "N.X", "N.Y", "N.Z", "Z"};

std::vector<float> values(const std::optional<Image>& image) {
    if (!image) return {};
    return {image->f32(), image->f32() + image->pixels.size() / sizeof(float)};
}

std::string layered_fault(const std::function<void()>& what) {
    try {
        what();
    } catch (const Error& error) {
        return error.what();
    }
    return "none";
}

/// A number that only channel `c` of pixel (x, y) has, and that every type of a channel holds.
float number(int x, int y, int c) { return static_cast<float>(1 + x + 16 * y + 256 * c % 1792); }

/// A part whose pixels are such numbers, by their places in the display window.
ExrPart numbers(ExrPart part) {
    for (int y = 0; y < part.height; ++y)
        for (int x = 0; x < part.width; ++x)
            for (std::size_t c = 0; c < part.channels.size(); ++c)
                part.values.push_back(number(x + part.x, y + part.y, static_cast<int>(c)));
    return part;
}

TEST(LayeredImage, TheColourIsNotTheFirstFourChannels) {
    const TempFolder folder;
    write_exr_parts(folder / "i.exr",
                    {{.channels = {"B", "G", "R", "Z"}, .values = {3, 2, 1, 7}, .width = 1, .height = 1}});
    EXPECT_THAT(values(read_image(folder / "i.exr")), ElementsAre(1, 2, 3)) << "depth is no alpha";
    write_exr_parts(folder / "n.exr",
                    {{.channels = {"A.X", "A.Y", "B", "G", "R"}, .values = {9, 9, 3, 2, 1}, .width = 1, .height = 1}});
    EXPECT_THAT(values(read_image(folder / "n.exr")), ElementsAre(1, 2, 3));
    write_exr_parts(folder / "z.exr", {{.channels = {"Z"}, .values = {7}, .width = 1, .height = 1}});
    EXPECT_THAT(values(read_image(folder / "z.exr")), ElementsAre(7)) << "what there is, where there is no colour";
    const std::string bytes = test::file_text(folder / "i.exr");
    EXPECT_THAT(values(read_image_memory("i.exr", std::as_bytes(std::span(bytes.data(), bytes.size())))),
                ElementsAre(1, 2, 3));
}

TEST(LayeredImage, LayersAreReadAndMadeWhole) {
    const TempFolder folder;
    write_exr_parts(folder / "i.exr", {{.channels = layered,
                                        .values = {.1f, .2f, .3f, 1, 0, 0, 2,     5,        //
                                                   .4f, .5f, .6f, 1, 3, 0, -4,    1e9f,     //
                                                   0,   0,   0,   0, 0, 0, 0,     infinity, //
                                                   0,   0,   0,   0, 0, 0, 1e-5f, 0},
                                        .width = 4,
                                        .height = 1}});
    const LayeredImage image = read_layers(folder / "i.exr", all);
    EXPECT_THAT(values(image.color), ElementsAre(.1f, .2f, .3f, 1, .4f, .5f, .6f, 1, 0, 0, 0, 0, 0, 0, 0, 0));
    EXPECT_THAT(values(image.normal), ElementsAre(0, 0, 1, .6f, 0, -.8f, 0, 0, 0, 0, 0, 0));
    EXPECT_THAT(values(image.depth), ElementsAre(5, no_depth, no_depth, no_depth));
    const LayeredImage normal = read_layers(folder / "i.exr", {.color = false, .normal = true, .depth = false});
    EXPECT_FALSE(normal.color || normal.depth);
    EXPECT_EQ(values(normal.normal), values(image.normal));
    const ImageInfo info = read_image_info(folder / "i.exr");
    EXPECT_EQ(info.size.width, 4);
    EXPECT_EQ(info.layers.color.size(), 4u);
    EXPECT_EQ(info.layers.depth.front().name, "Z");
}

TEST(LayeredImage, WhatIsNoExrHasColoursAlone) {
    const TempFolder folder;
    const Image image = make_image(3, 2, 4, PixelType::u8);
    write_png(folder / "i.png", image);
    const LayeredImage read = read_layers(folder / "i.png", all);
    EXPECT_TRUE(read.color->pixels == image.pixels);
    EXPECT_FALSE(read.normal || read.depth);
    EXPECT_EQ(read_image_info(folder / "i.png").layers.color.size(), 4u);
}

TEST(LayeredImage, WithoutAColourItIsTransparent) {
    const TempFolder folder;
    write_exr_parts(folder / "i.exr",
                    {{.channels = {"N.X", "N.Y", "N.Z"}, .values = {0, 1, 0}, .width = 1, .height = 1}});
    const LayeredImage read = read_layers(folder / "i.exr", all);
    EXPECT_THAT(values(read.color), ElementsAre(0, 0, 0, 0));
    EXPECT_THAT(values(read.normal), ElementsAre(0, 1, 0));
}

/// Every pixel of every layer, through all that an EXR can do with its pixels.
TEST(LayeredImage, TilesTypesWindowsAndCompressions) {
    const TempFolder folder;
    using OIIO::TypeDesc;
    const std::vector<TypeDesc> mixed{TypeDesc::HALF,  TypeDesc::HALF,  TypeDesc::HALF,  TypeDesc::UINT32,
                                      TypeDesc::FLOAT, TypeDesc::FLOAT, TypeDesc::FLOAT, TypeDesc::UINT32};
    const std::vector<ExrPart> cases{
        {.channels = layered, .width = 13, .height = 11},
        {.channels = layered, .width = 13, .height = 11, .types = mixed},
        {.channels = layered, .width = 13, .height = 11, .tile = 4},
        {.channels = layered, .width = 13, .height = 11, .types = mixed, .tile = 4},
        {.channels = layered, .width = 5, .height = 3, .x = 4, .y = 6, .full_width = 13, .full_height = 11},
        {.channels = layered,
         .width = 5,
         .height = 3,
         .x = 10,
         .y = 9,
         .full_width = 13,
         .full_height = 11,
         .types = mixed},
        {.channels = layered,
         .width = 20,
         .height = 19,
         .x = -4,
         .y = -5,
         .full_width = 13,
         .full_height = 11,
         .tile = 8},
        {.channels = layered, .width = 3, .height = 3, .x = 20, .y = -9, .full_width = 13, .full_height = 11},
        {.channels = layered, .width = 13, .height = 11, .compression = "none"},
        {.channels = layered, .width = 13, .height = 11, .compression = "piz"},
    };
    for (std::size_t i = 0; i < cases.size(); ++i) {
        SCOPED_TRACE(i);
        const ExrPart part = numbers(cases[i]);
        write_exr_parts(folder / "i.exr", {part});
        const LayeredImage image = read_layers(folder / "i.exr", all);
        ASSERT_EQ(image.color->width, 13);
        ASSERT_EQ(image.depth->height, 11);
        EXPECT_EQ(read_upright_size(folder / "i.exr").width, 13);
        int wrong = 0;
        for (int y = 0; y < 11; ++y)
            for (int x = 0; x < 13; ++x) {
                const bool inside = x >= part.x && x < part.x + part.width && y >= part.y && y < part.y + part.height;
                const int pixel = y * 13 + x;
                for (int c = 0; c < 4; ++c)
                    wrong += image.color->f32()[4 * pixel + c] != (inside ? number(x, y, c) : 0);
                wrong += image.depth->f32()[pixel] != (inside ? number(x, y, 7) : no_depth);
                const double length = std::hypot(number(x, y, 4), number(x, y, 5), number(x, y, 6));
                for (int c = 0; c < 3; ++c)
                    wrong += std::abs(image.normal->f32()[3 * pixel + c] -
                                      (inside ? number(x, y, 4 + c) / length : 0.0)) > 1e-6;
            }
        EXPECT_EQ(wrong, 0);
    }
}

/// More rows than are decoded at once.
TEST(LayeredImage, TallImages) {
    const TempFolder folder;
    for (const int tile : {0, 64}) {
        ExrPart part{.channels = {"R", "G", "B", "Z"}, .width = 2, .height = 700, .tile = tile};
        for (int i = 0; i < 4 * 1400; ++i) part.values.push_back(static_cast<float>(i + 1));
        write_exr_parts(folder / "i.exr", {part});
        const LayeredImage image = read_layers(folder / "i.exr", all);
        int wrong = 0;
        for (int i = 0; i < 1400; ++i) wrong += image.depth->f32()[i] != static_cast<float>(4 * i + 4);
        EXPECT_EQ(wrong, 0) << tile;
    }
}

TEST(LayeredImage, PartsHaveLayersNames) {
    const TempFolder folder;
    const auto part = [](std::string name, std::vector<std::string> channels, std::vector<float> pixel) {
        return ExrPart{.channels = std::move(channels),
                       .values = std::move(pixel),
                       .width = 1,
                       .height = 1,
                       .name = std::move(name)};
    };
    write_exr_parts(folder / "i.exr",
                    {part("AO", {"Y"}, {9}), part("rgba", {"R", "G", "B", "A"}, {1, 2, 3, 1}),
                     part("ViewLayer.Normal", {"X", "Y", "Z"}, {0, 2, 0}), part("depth", {"Z"}, {4})});
    const LayeredImage image = read_layers(folder / "i.exr", all);
    EXPECT_THAT(values(image.color), ElementsAre(1, 2, 3, 1));
    EXPECT_THAT(values(image.normal), ElementsAre(0, 1, 0));
    EXPECT_THAT(values(image.depth), ElementsAre(4));
    EXPECT_THAT(values(read_image(folder / "i.exr")), ElementsAre(1, 2, 3, 1));
    std::vector<ExrPart> stereo{part("rgba.right", {"R", "G", "B"}, {1, 2, 3}),
                                part("N.right", {"X", "Y", "Z"}, {0, 2, 0}),
                                part("rgba.left", {"R", "G", "B"}, {4, 5, 6})};
    for (ExrPart& each : stereo) each.view = each.name.ends_with("right") ? "right" : "left";
    write_exr_parts(folder / "s.exr", stereo);
    EXPECT_THAT(values(read_layers(folder / "s.exr", all).color), ElementsAre(1, 2, 3)) << "the first view";
    EXPECT_THAT(values(read_layers(folder / "s.exr", all).normal), ElementsAre(0, 1, 0));
}

TEST(LayeredImage, WhatIsNoNumberHasItsPlace) {
    const TempFolder folder;
    const auto fault_with = [&](std::size_t channel, float value) {
        ExrPart part{.channels = layered, .values = std::vector<float>(8 * 12, 1.0f), .width = 4, .height = 3};
        part.values[8 * (4 * 1 + 2) + channel] = value;
        write_exr_parts(folder / "i.exr", {part});
        return layered_fault([&] { static_cast<void>(read_layers(folder / "i.exr", all)); });
    };
    const std::string start = (folder / "i.exr").string() + ": has values that are not finite ";
    EXPECT_EQ(fault_with(1, nan), start + "(color, channel G, column 2, row 1)");
    EXPECT_EQ(fault_with(0, infinity), start + "(color, channel R, column 2, row 1)");
    EXPECT_EQ(fault_with(6, nan), start + "(normal, channel N.Z, column 2, row 1)");
    EXPECT_EQ(fault_with(4, -infinity), start + "(normal, channel N.X, column 2, row 1)");
    EXPECT_EQ(fault_with(7, nan), start + "(depth, channel Z, column 2, row 1)");
    EXPECT_EQ(fault_with(7, -infinity), "none") << "nothing is there";
    static_cast<void>(fault_with(6, nan));
    EXPECT_EQ(values(read_layers(folder / "i.exr", {.color = true, .normal = false, .depth = true}).depth).size(), 12u)
        << "layers that nobody wants are not looked at";
}

TEST(LayeredImage, BrokenFilesAreRefusedByName) {
    const TempFolder folder;
    write_exr_parts(folder / "whole.exr", {numbers({.channels = layered, .width = 64, .height = 64})});
    const std::string whole = test::file_text(folder / "whole.exr");
    for (std::size_t part = 0; part < 8; ++part) {
        const auto file = folder.write("cut.exr", whole.substr(0, whole.size() * part / 8));
        EXPECT_THAT(layered_fault([&] { static_cast<void>(read_layers(file, all)); }),
                    testing::StartsWith(file.string() + ": "));
    }
    EXPECT_THAT(layered_fault([&] { static_cast<void>(read_image_info(folder / "absent.exr")); }),
                HasSubstr("absent.exr: is not a file that can be read"));
    const ExrPart huge{
        .channels = {"R"}, .values = {1}, .width = 1, .height = 1, .full_width = 60000, .full_height = 60000};
    write_exr_parts(folder / "huge.exr", {huge});
    EXPECT_THAT(layered_fault([&] { static_cast<void>(read_layers(folder / "huge.exr", all)); }),
                HasSubstr("is too large: 60000x60000"));
    EXPECT_THAT(layered_fault([&] { static_cast<void>(read_image(folder / "huge.exr")); }), HasSubstr("is too large"));
}

/// Bytes changed one or a few at a time, most of them in the header: read, or refused with the file's name.
TEST(LayeredImage, DamagedFilesAreReadOrRefused) {
    const TempFolder folder;
    write_exr_parts(folder / "lines.exr", {numbers({.channels = layered, .width = 16, .height = 16})});
    write_exr_parts(folder / "tiles.exr", {numbers({.channels = layered, .width = 16, .height = 16, .tile = 8})});
    std::uint32_t state = 1;
    const auto random = [&](std::size_t below) {
        state = state * 1664525u + 1013904223u;
        return static_cast<std::size_t>(state >> 8) % below;
    };
    int refused = 0;
    for (int i = 0; i < test::mutation_count() / 2; ++i) {
        std::string bytes = test::file_text(folder / (i % 2 ? "lines.exr" : "tiles.exr"));
        for (std::size_t n = 0; n <= random(3); ++n)
            bytes[random(random(4) > 0 ? 700 : bytes.size())] ^= static_cast<char>(1u << random(8));
        const auto file = folder.write("d.exr", bytes);
        const std::string found = layered_fault([&] { static_cast<void>(read_layers(file, all)); });
        refused += found != "none";
        EXPECT_TRUE(found == "none" || found.starts_with(file.string() + ": ")) << i << ": " << found;
        EXPECT_EQ(found.find('\n'), found.npos);
    }
    EXPECT_GT(refused, test::mutation_count() / 20);
}

} // namespace
} // namespace hachure::assets
