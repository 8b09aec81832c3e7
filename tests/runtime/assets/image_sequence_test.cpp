#include <hachure/runtime/assets/image_file.h>
#include <hachure/runtime/assets/image_sequence.h>
#include <hachure/runtime/error.h>
#include <hachure/tests/support/exr_file.h>
#include <hachure/tests/support/temp_folder.h>

#include <gmock/gmock.h>

#include <functional>

namespace hachure::assets {
namespace {

using test::TempFolder;
using testing::ElementsAre;
using testing::HasSubstr;

std::string sequence_fault(const std::function<void()>& what) {
    try {
        what();
    } catch (const Error& error) {
        return error.what();
    }
    return "none";
}

std::vector<std::int64_t> numbers(const std::filesystem::path& pattern) {
    const NumberedFiles files(pattern);
    return {files.numbers().begin(), files.numbers().end()};
}

TEST(NumberedFiles, AreThoseThatAreThereInTheOrderOfTheirNumbers) {
    const TempFolder folder;
    for (const char* name : {"a.0012.png", "a.0003.png", "a.12345.png", "a.0010.png", "a.001.png", "a.00014.png",
                             "a.0x11.png", "a.-001.png", "a..png", "b.0001.png", "a.0001.exr", "xa.0001.png",
                             "a.0001.pngx", "a.99999999999999999999.png", "a.1000000000.png", "a.png"})
        folder.write(name, "");
    EXPECT_THAT(numbers(folder / "a.####.png"), ElementsAre(3, 10, 12, 12345));
    EXPECT_THAT(numbers(folder / "a.###.png"), ElementsAre(1, 12345)) << "longer numbers take the room they need";
    const NumberedFiles files(folder / "a.####.png");
    EXPECT_EQ(files.frame_count(), 12343);
    EXPECT_EQ(files.missing(), 12339);
    EXPECT_EQ(files.file(0), folder / "a.0003.png");
    EXPECT_EQ(files.shown_frame(6), 0) << "holds the one before";
    EXPECT_EQ(files.file(6), folder / "a.0003.png");
    EXPECT_EQ(files.file(7), folder / "a.0010.png");
    EXPECT_EQ(files.shown_frame(12341), 9);
    EXPECT_EQ(files.file(12342), folder / "a.12345.png");
}

TEST(NumberedFiles, NameWhatIsWrong) {
    const TempFolder folder;
    folder.write("a#.png", "");
    EXPECT_FALSE(is_numbered_name(folder / "a#.png")) << "a file that is called so is that file";
    EXPECT_TRUE(is_numbered_name(folder / "b#.png"));
    EXPECT_FALSE(is_numbered_name(folder / "b.png"));
    EXPECT_THAT(sequence_fault([&] { numbers(folder / "b.###.png"); }),
                HasSubstr("b.###.png: names no file that is there, such as b.001.png"));
    EXPECT_THAT(sequence_fault([&] { numbers(folder / "b#.##.png"); }), HasSubstr("b#.##.png: "));
    EXPECT_THAT(sequence_fault([&] { numbers(folder / "absent/b.#.png"); }), HasSubstr("absent/b.#.png: "));
}

void write_frame(const std::filesystem::path& file, std::vector<std::string> channels, float value, int width = 1) {
    test::ExrPart part{.channels = std::move(channels), .width = width, .height = 1};
    part.values.assign(part.channels.size() * std::size_t(width), value);
    test::write_exr_parts(file, {part});
}

TEST(ImageSequence, GivesTheFramesOfItsFiles) {
    const TempFolder folder;
    for (const int number : {7, 8, 10})
        write_frame(folder / ("s." + std::to_string(number) + ".exr"), {"R", "G", "B", "Z"}, float(number));
    const ImageSequence sequence(folder / "s.#.exr");
    EXPECT_EQ(sequence.files().frame_count(), 4);
    EXPECT_EQ(sequence.info().size.width, 1);
    const int wanted[] = {7, 8, 8, 10};
    for (int i = 0; i < 4; ++i) {
        const LayeredImage image = sequence.read_frame(i, {.color = true, .normal = true, .depth = true});
        EXPECT_EQ(image.color->f32()[0], float(wanted[i]));
        EXPECT_EQ(image.depth->f32()[0], float(wanted[i]));
        EXPECT_FALSE(image.normal);
    }
}

TEST(ImageSequence, FilesThatDifferAreNamed) {
    const TempFolder folder;
    const std::vector<std::string> channels{"R", "G", "B", "Z"};
    for (const char* name : {"s.1.exr", "s.2.exr", "s.3.exr"}) write_frame(folder / name, channels, 1.0f);
    const auto opened = [&] { return sequence_fault([&] { static_cast<void>(ImageSequence(folder / "s.#.exr")); }); };
    EXPECT_EQ(opened(), "none");
    write_frame(folder / "s.3.exr", channels, 1.0f, 2);
    EXPECT_THAT(opened(), HasSubstr("s.3.exr: has 2x1 pixels, not the 1x1 that the sequence's first, s.1.exr, has"));
    write_frame(folder / "s.3.exr", {"R", "G", "B"}, 1.0f);
    EXPECT_THAT(opened(), HasSubstr("s.3.exr: lacks the depth that"));
    folder.write("s.3.exr", "text");
    EXPECT_THAT(opened(), HasSubstr("s.3.exr: "));
    write_frame(folder / "s.3.exr", channels, 1.0f);
    const ImageSequence sequence(folder / "s.#.exr");
    write_frame(folder / "s.2.exr", channels, 1.0f, 2);
    EXPECT_THAT(sequence_fault([&] { static_cast<void>(sequence.read_frame(1, {.color = true})); }),
                HasSubstr("s.2.exr: has another size"));
}

TEST(ImageSequence, AnyKindOfImage) {
    const TempFolder folder;
    for (const char* name : {"s01.png", "s02.png"}) write_png(folder / name, make_image(3, 2, 3, PixelType::u8));
    const ImageSequence sequence(folder / "s##.png");
    EXPECT_EQ(sequence.read_frame(1, {.color = true}).color->width, 3);
}

} // namespace
} // namespace hachure::assets
