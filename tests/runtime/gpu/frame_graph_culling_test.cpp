#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "frame_graph_bench.h"

namespace hachure::gpu::testing {
namespace {

using ::testing::ElementsAre;

// a -> [x] -> b -> [y]      nothing is required
TEST(FrameGraphCulling, WithoutARequirementNothingRuns) {
    TestBench bench;
    bench.pass({.name = "a", .creates = {"x"}});
    bench.pass({.name = "b", .creates = {"y"}, .reads = {"x"}});
    EXPECT_EQ(bench.run(), "a:culled b:culled");
    EXPECT_EQ(bench.backend.created(), 0u);
}

// a -> [x] -> b -> [y] -> c -> [z]      y is required
TEST(FrameGraphCulling, AChainIsCutBehindTheRequirement) {
    TestBench bench;
    bench.pass({.name = "a", .creates = {"x"}});
    bench.pass({.name = "b", .creates = {"y"}, .reads = {"x"}});
    bench.pass({.name = "c", .creates = {"z"}, .reads = {"y"}});
    bench.require("y");
    EXPECT_EQ(bench.run(), "a:run b:run c:culled");
    EXPECT_THAT(bench.backend.passes(), ElementsAre("a", "b"));
}

//          +-> b -> [y] -+
// a -> [x] +             +-> d -> [w]      w is required
//          +-> c -> [z] -+
TEST(FrameGraphCulling, ADiamondStaysWhole) {
    TestBench bench;
    bench.pass({.name = "a", .creates = {"x"}});
    bench.pass({.name = "b", .creates = {"y"}, .reads = {"x"}});
    bench.pass({.name = "c", .creates = {"z"}, .reads = {"x"}});
    bench.pass({.name = "d", .creates = {"w"}, .reads = {"y", "z"}});
    bench.require("w");
    EXPECT_EQ(bench.run(), "a:run b:run c:run d:run");
    EXPECT_THAT(bench.backend.passes(), ElementsAre("a", "b", "c", "d"));
}

//          +-> b -> [y]       y is required: the other arm goes, and what only it needed
// a -> [x] +
//          +-> c -> [z] <- e -> [v]
TEST(FrameGraphCulling, HalfADiamondTakesWhatOnlyItNeeded) {
    TestBench bench;
    bench.pass({.name = "a", .creates = {"x"}});
    bench.pass({.name = "e", .creates = {"v"}});
    bench.pass({.name = "b", .creates = {"y"}, .reads = {"x"}});
    bench.pass({.name = "c", .creates = {"z"}, .reads = {"x", "v"}});
    bench.require("y");
    EXPECT_EQ(bench.run(), "a:run e:culled b:run c:culled");
}

// a -> [x][y]      only y is required: the pass runs, and has a texture for x to write
TEST(FrameGraphCulling, OneUsedOutputKeepsAllOfThePass) {
    TestBench bench;
    bench.pass({.name = "a", .creates = {"x", "y"}});
    bench.require("y");
    EXPECT_EQ(bench.run(), "a:run");
    EXPECT_EQ(bench.backend.created(), 2u);
}

// a -> [x1] -> b -> [x2]      read by r before b writes onto it; b's version is not wanted
//        +---> r -> [y]
TEST(FrameGraphCulling, AWriterIsCulledWhenOnlyTheEarlierVersionIsRead) {
    TestBench bench;
    bench.pass({.name = "a", .creates = {"x"}});
    bench.pass({.name = "r", .creates = {"y"}, .reads = {"x"}});
    bench.pass({.name = "b", .writes = {"x"}});
    bench.require("y");
    EXPECT_EQ(bench.run(), "a:run r:run b:culled");
}

// a -> [x1] -> b -> [x2] -> c -> [x3]      x3 is required: writing onto a version needs it
TEST(FrameGraphCulling, WritingOntoAVersionNeedsItsWriter) {
    TestBench bench;
    bench.pass({.name = "a", .creates = {"x"}});
    bench.pass({.name = "b", .writes = {"x"}});
    bench.pass({.name = "c", .writes = {"x"}});
    bench.require("x");
    EXPECT_EQ(bench.run(), "a:run b:run c:run");
}

// a -> [x] -> save (side effect)
TEST(FrameGraphCulling, ASideEffectIsNeededAndNeedsItsInputs) {
    TestBench bench;
    bench.pass({.name = "a", .creates = {"x"}});
    bench.pass({.name = "save", .reads = {"x"}, .side_effect = true});
    EXPECT_EQ(bench.run(), "a:run save:run");
}

// a -> [window1]      imported: nobody outside asked for it in the second frame
TEST(FrameGraphCulling, AnImportedTargetIsNotARequirement) {
    TestBench bench;
    bench.import("window", 1000);
    bench.pass({.name = "a", .writes = {"window"}});
    bench.require("window");
    EXPECT_EQ(bench.run(), "a:run");
    bench.import("window", 1000);
    bench.pass({.name = "a", .writes = {"window"}});
    EXPECT_EQ(bench.run(), "a:culled");
}

// a -> [x]  =published as "depth"=>  b -> [y]      b knows only the name
TEST(FrameGraphCulling, PublishedNamesConnectPasses) {
    TestBench bench;
    EXPECT_FALSE(bench.graph.find("depth"));
    bench.pass({.name = "a", .creates = {"x"}});
    bench.graph.publish("depth", bench.newest["x"]);
    bench.newest["found"] = bench.graph.find("depth");
    bench.pass({.name = "b", .creates = {"y"}, .reads = {"found"}});
    bench.require("y");
    EXPECT_EQ(bench.run(), "a:run b:run");
    EXPECT_FALSE(bench.graph.find("depth")) << "names are of one frame";
}

TEST(FrameGraphCulling, AnEmptyFrameIsAFrame) {
    TestBench bench;
    EXPECT_EQ(bench.run(), "");
    EXPECT_EQ(bench.run(), "");
}

} // namespace
} // namespace hachure::gpu::testing
