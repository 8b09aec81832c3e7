#include <hachure/runtime/assets/file_bytes.h>
#include <hachure/runtime/assets/path_rules.h>
#include <hachure/runtime/error.h>

#include <gtest/gtest.h>

#include "gltf_builder.h"

namespace hachure::assets {
namespace {

using namespace gltf_testing;
namespace fs = std::filesystem;

TEST(PathRules, DecodesPercents) {
    EXPECT_EQ(percent_decode("a%20b%2Fc%2f"), "a b/c/");
    EXPECT_EQ(percent_decode("100%"), "100%");
    EXPECT_EQ(percent_decode("%zz%4"), "%zz%4");
    EXPECT_EQ(percent_decode("%252e"), "%2e") << "decoded once, not twice";
}

TEST(PathRules, AcceptsNamesBelowTheFile) {
    const TempFolder folder;
    const fs::path file = folder / "model.gltf";
    EXPECT_EQ(resolve_beside(file, "a.bin"), folder / "a.bin");
    EXPECT_EQ(resolve_beside(file, "sub/./deep%20er/a.bin").lexically_normal(), folder / "sub/deep er/a.bin");
    EXPECT_EQ(resolve_beside(file, "sub/../a.bin").lexically_normal(), folder / "a.bin");
    EXPECT_EQ(resolve_beside("model.gltf", "a.bin").filename(), "a.bin");
}

class PathRulesRefuse : public testing::TestWithParam<const char*> {};

TEST_P(PathRulesRefuse, WhatLeavesTheFolder) {
    const TempFolder folder;
    fs::create_directory(folder / "inner");
    write_file(folder / "secret", std::string("x"));
    EXPECT_THROW((void)resolve_beside(folder / "inner/model.gltf", GetParam()), Error) << GetParam();
}

INSTANTIATE_TEST_SUITE_P(Names, PathRulesRefuse,
                         testing::Values("", "/etc/passwd", "../secret", "a/../../secret", "%2e%2e/secret",
                                         "..%2Fsecret", "http://host/a.bin", "file:///etc/passwd", "FILE:a", "C:/a.bin",
                                         "c:a", "..\\secret", "a%5Cb", "%5C%5Chost%5Cshare", "a%00.bin",
                                         "%2Fetc/passwd", ".."));

TEST(PathRules, RefusesSymbolicLinksThatLeaveTheFolder) {
    const TempFolder folder;
    fs::create_directory(folder / "inner");
    fs::create_directory(folder / "outside");
    write_file(folder / "outside/secret.bin", std::string("x"));
    write_file(folder / "inner/real.bin", std::string("x"));
    fs::create_symlink(folder / "outside/secret.bin", folder / "inner/link.bin");
    fs::create_directory_symlink(folder / "outside", folder / "inner/linked");
    fs::create_symlink("real.bin", folder / "inner/inside.bin");
    const fs::path file = folder / "inner/model.gltf";
    EXPECT_THROW((void)resolve_beside(file, "link.bin"), Error);
    EXPECT_THROW((void)resolve_beside(file, "linked/secret.bin"), Error);
    EXPECT_THROW((void)resolve_beside(file, "linked/../secret.bin"), Error);
    EXPECT_NO_THROW((void)resolve_beside(file, "inside.bin"));
}

TEST(FileBytes, ReadsRegularFilesOnly) {
    const TempFolder folder;
    write_file(folder / "five", std::string("12345"));
    EXPECT_EQ(read_file_bytes(folder / "five").size(), 5u);
    EXPECT_EQ(read_file_bytes(folder / "five", 5).size(), 5u);
    EXPECT_THROW((void)read_file_bytes(folder / "five", 4), Error);
    EXPECT_THROW((void)read_file_bytes(folder.path()), Error);
    EXPECT_THROW((void)read_file_bytes(folder / "none"), Error);
    EXPECT_THROW((void)read_file_bytes("/dev/zero"), Error);
    EXPECT_THROW((void)read_file_bytes(folder / "five/under"), Error);
}

} // namespace
} // namespace hachure::assets
