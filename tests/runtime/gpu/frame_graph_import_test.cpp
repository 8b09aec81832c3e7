#include <gtest/gtest.h>

#include "frame_graph_bench.h"

namespace hachure::gpu::testing {
namespace {

TEST(FrameGraphImport, AnImportedTextureAndAnOwnedOneOfOneNameAreTwo) {
    TestBench bench;
    const auto frame = [&](bool imported) {
        bench.begin();
        if (imported) bench.import("x", 1000);
        const std::vector<std::string> x{"x"}, none;
        bench.pass({.name = "a", .creates = imported ? none : x, .writes = imported ? x : none, .key = 1});
        bench.require("x");
        EXPECT_EQ(bench.run_only(), "a:run");
        return bench.graph.texture(bench.newest["x"]);
    };
    EXPECT_EQ(frame(true), 1000u);
    EXPECT_NE(frame(false), 1000u);
    EXPECT_EQ(frame(true), 1000u);
}

TEST(FrameGraphImport, AnImportedTargetKeepsItsResultsIfItsOwnerSaysSo) {
    TestBench bench;
    const auto frame = [&](std::uint32_t id, bool retained) {
        bench.import("window", id, {.contents = {}, .retained = retained});
        bench.pass({.name = "a", .writes = {"window"}, .key = 1});
        bench.require("window");
        return bench.run();
    };
    EXPECT_EQ(frame(1000, true), "a:run");
    EXPECT_EQ(frame(1000, true), "a:reused");
    EXPECT_EQ(frame(1001, true), "a:run") << "another texture behind the name";
    EXPECT_EQ(frame(1001, true), "a:reused");
    EXPECT_EQ(frame(1001, false), "a:run") << "a back buffer";
    EXPECT_EQ(frame(1001, false), "a:run");
    EXPECT_EQ(bench.backend.created(), 0u);
}

// [video0] -> a -> [x]      the video's key is its frame number
TEST(FrameGraphImport, ReadersOfAnImportedTextureDependOnItsContents) {
    TestBench bench;
    const auto frame = [&](std::uint64_t number) {
        bench.import("video", 1000, {.contents = number});
        bench.pass({.name = "a", .creates = {"x"}, .reads = {"video"}, .key = 1});
        bench.require("x");
        return bench.run();
    };
    frame(7);
    EXPECT_EQ(frame(7), "a:reused");
    EXPECT_EQ(frame(8), "a:run");
}

} // namespace
} // namespace hachure::gpu::testing
