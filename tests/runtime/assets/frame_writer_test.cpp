#include <hachure/runtime/assets/frame_writer.h>
#include <hachure/runtime/assets/image_file.h>
#include <hachure/runtime/error.h>
#include <hachure/tests/runtime/assets/film_frames.h>
#include <hachure/tests/support/process.h>
#include <hachure/tests/support/temp_folder.h>

#include <gtest/gtest.h>

#include <csignal>

namespace hachure::assets {
namespace {

using test::drawn_frame;
using test::TempFolder;

TEST(FrameWriter, KnowsItsExtensions) {
    EXPECT_EQ(frame_format("a.png"), FrameFormat::png);
    EXPECT_EQ(frame_format("a.b/A.####.EXR"), FrameFormat::exr);
    EXPECT_EQ(frame_format("a.gif"), FrameFormat::gif);
    EXPECT_EQ(frame_format("a.MP4"), FrameFormat::mp4);
    EXPECT_EQ(frame_format("a.####.svg"), FrameFormat::svg);
    for (const char* name : {"a.avi", "a", "gif", "a.gif/b", ".mp4", ""})
        EXPECT_EQ(frame_format(name), std::nullopt) << name;
}

TEST(FrameWriter, NumbersPngFiles) {
    const TempFolder folder;
    const auto writer = make_frame_writer(folder / "a.###.png", {});
    for (const int number : {8, 9, 1000}) {
        writer->write(number, drawn_frame(20, 10, number % 7));
        EXPECT_TRUE(std::filesystem::exists(
            folder / ("a." + std::string(number > 9 ? "" : "00") + std::to_string(number) + ".png")))
            << "before the next one is drawn";
    }
    writer->finish();
    EXPECT_EQ(folder.listing(), (std::set<std::string>{"a.008.png", "a.009.png", "a.1000.png"}));
    EXPECT_EQ(read_image(folder / "a.009.png").pixels, drawn_frame(20, 10, 2).pixels);
}

TEST(FrameWriter, NumbersExrFiles) {
    const TempFolder folder;
    const auto writer = make_frame_writer(folder / "n.##.exr", {{}, {"Z"}});
    Image image = make_image(4, 3, 1, PixelType::f32);
    for (const int number : {0, 1}) {
        image.f32()[5] = 0.25f + static_cast<float>(number);
        writer->write(number, image);
    }
    writer->finish();
    EXPECT_EQ(folder.listing(), (std::set<std::string>{"n.00.exr", "n.01.exr"}));
    EXPECT_EQ(read_image(folder / "n.01.exr").f32()[5], 1.25f);
}

TEST(FrameWriter, AFilmAppearsAtItsEndOnly) {
    for (const char* name : {"a.gif", "a.mp4"}) {
        const TempFolder folder;
        folder.write(name, "old");
        const auto writer = make_frame_writer(folder / name, {});
        for (int i = 0; i < 40; ++i) writer->write(i, drawn_frame(64, 48, i)); // more than encoders keep back
        EXPECT_EQ(test::file_text(folder / name), "old");
        writer->finish();
        EXPECT_GT(test::file_text(folder / name).size(), 100u);
        EXPECT_EQ(folder.listing(), std::set<std::string>{name});
    }
}

TEST(FrameWriter, AFilmThatIsGivenUpLeavesNothing) {
    for (const char* name : {"a.gif", "a.mp4"})
        for (const int frames : {0, 1, 40}) {
            const TempFolder folder;
            folder.write(name, "old");
            try {
                const auto writer = make_frame_writer(folder / name, {});
                for (int i = 0; i < frames; ++i) writer->write(i, drawn_frame(64, 48, i));
                throw std::runtime_error("drawing failed");
            } catch (const std::runtime_error&) {
            }
            EXPECT_EQ(folder.listing(), std::set<std::string>{name}) << name << " " << frames;
            EXPECT_EQ(test::file_text(folder / name), "old");
        }
}

TEST(FrameWriter, WhatCannotBeWrittenIsNamed) {
    const TempFolder folder;
    std::filesystem::create_directory(folder / "d.gif");
    for (const char* name : {"absent/a.gif", "absent/a.mp4", "absent/a.#.png", "d.gif"}) {
        const std::filesystem::path file = folder / name;
        std::string fault;
        try {
            make_frame_writer(file, {})->write(0, drawn_frame(8, 8, 0));
        } catch (const Error& error) {
            fault = error.what();
        }
        EXPECT_TRUE(fault.starts_with((folder / name).parent_path().string())) << name << ": " << fault;
    }
    EXPECT_EQ(folder.listing(), std::set<std::string>{"d.gif"});
}

/// A process that may write files of `limit` bytes only, as if the disk were full behind them. Exits with 3 when the
/// writer says so.
int write_with_limit(const char* name, rlim_t limit) {
    std::signal(SIGXFSZ, SIG_IGN);
    const rlimit files{limit, limit};
    ::setrlimit(RLIMIT_FSIZE, &files);
    try {
        const auto writer = make_frame_writer(name, {});
        for (int i = 0; i < 60; ++i) writer->write(i, drawn_frame(128, 96, i));
        writer->finish();
    } catch (const Error& error) {
        const std::string fault = error.what();
        return fault.starts_with("a.") && fault.find(": can't be written") != fault.npos ? 3 : 4;
    }
    return 0;
}

TEST(FrameWriter, AFullDiskLeavesNothing) {
    for (const char* name : {"a.gif", "a.mp4", "a.##.png"})
        for (const rlim_t limit : {rlim_t{0}, rlim_t{1000}, rlim_t{5000}}) {
            if (std::string(name) == "a.##.png" && limit != 0) continue; // small files fit
            const TempFolder folder;
            test::Process process([&] { return write_with_limit(name, limit); }, folder.path());
            const test::ProcessResult result = process.wait();
            EXPECT_EQ(result.exit_code, 3) << name << " " << limit << " " << result.err;
            EXPECT_TRUE(folder.listing().empty()) << name << " " << limit;
        }
}

} // namespace
} // namespace hachure::assets
