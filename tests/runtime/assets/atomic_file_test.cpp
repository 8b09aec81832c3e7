#include <hachure/runtime/assets/atomic_file.h>
#include <hachure/runtime/assets/text_file.h>
#include <hachure/runtime/error.h>
#include <hachure/tests/support/temp_folder.h>

#include <gtest/gtest.h>
#include <sys/stat.h>

namespace hachure::assets {
namespace {

using test::TempFolder;

void write(const std::filesystem::path& file, std::string_view text) {
    write_file_atomically(file, std::as_bytes(std::span(text.data(), text.size())));
}

template <class Work> std::string fault(Work work) {
    try {
        work();
    } catch (const Error& error) {
        return error.what();
    }
    return {};
}

TEST(AtomicFile, WritesAndOverwrites) {
    const TempFolder folder;
    for (const std::string text : {"first, which is longer", "second", ""}) {
        write(folder / "f", text);
        EXPECT_EQ(test::file_text(folder / "f"), text);
        EXPECT_EQ(folder.listing(), std::set<std::string>{"f"});
    }
}

TEST(AtomicFile, HasTheModeOfAnyNewFile) {
    const TempFolder folder;
    const mode_t before = ::umask(027);
    write(folder / "f", "text");
    EXPECT_EQ(::umask(before), 027u) << "the mask was changed";
    struct stat status {};
    ASSERT_EQ(::stat((folder / "f").c_str(), &status), 0);
    EXPECT_EQ(status.st_mode & 0777u, 0640u);
}

TEST(AtomicFile, FailureLeavesNothingAndNamesTheFile) {
    const TempFolder folder;
    std::filesystem::create_directory(folder / "d");
    const auto before = folder.listing();
    for (const char* name : {"d", "absent/f", "d/absent/f"}) {
        const std::filesystem::path file = folder / name;
        EXPECT_TRUE(fault([&] { write(file, "text"); }).starts_with(file.string() + ": ")) << name;
    }
    EXPECT_EQ(folder.listing(), before);
}

TEST(AtomicFile, LongNamesFailCleanly) {
    const TempFolder folder;
    EXPECT_THROW(write(folder / std::string(300, 'x'), "text"), Error);
    EXPECT_TRUE(folder.listing().empty());
}

TEST(TextFile, ReadsUpToItsLimit) {
    const TempFolder folder;
    const auto file = folder.write("t", std::string("a\0b\r\n", 5));
    EXPECT_EQ(read_text_file(file, 5), std::string("a\0b\r\n", 5));
    EXPECT_TRUE(fault([&] { static_cast<void>(read_text_file(file, 4)); }).starts_with(file.string() + ": is larger"));
    EXPECT_EQ(read_text_file(folder.write("empty", ""), 0), "");
}

TEST(TextFile, NamesWhatItCannotRead) {
    const TempFolder folder;
    EXPECT_TRUE(fault([&] {
                    static_cast<void>(read_text_file(folder / "absent", 9));
                }).ends_with("absent: there is no such file"));
    EXPECT_FALSE(fault([&] { static_cast<void>(read_text_file(folder.path(), 9)); }).empty());
    EXPECT_FALSE(fault([&] { static_cast<void>(read_text_file("/dev/zero", 9)); }).empty());
}

} // namespace
} // namespace hachure::assets
