#include <gtest/gtest.h>

#include "frame_graph_bench.h"

namespace hachure::gpu::testing {
namespace {

// a(ka) -> [x] -> b(kb) -> [y]      y is required
TEST(FrameGraphReuse, NothingChangedRunsNothing) {
    TestBench bench;
    EXPECT_EQ(chain_frame(bench, 1, 1), "a:run b:run");
    bench.backend.clear_passes();
    for (int frame = 0; frame < 5; ++frame) EXPECT_EQ(chain_frame(bench, 1, 1), "a:reused b:reused");
    EXPECT_TRUE(bench.backend.passes().empty());
    EXPECT_EQ(bench.backend.created(), 2u);
}

TEST(FrameGraphReuse, AChangeRunsThePassAndWhatFollows) {
    TestBench bench;
    chain_frame(bench, 1, 1);
    EXPECT_EQ(chain_frame(bench, 1, 2), "a:reused b:run");
    EXPECT_EQ(chain_frame(bench, 2, 2), "a:run b:run");
    EXPECT_EQ(chain_frame(bench, 2, 2), "a:reused b:reused");
}

TEST(FrameGraphReuse, OnlyTheLatestResultIsKept) {
    TestBench bench;
    chain_frame(bench, 1, 1);
    chain_frame(bench, 2, 1);
    EXPECT_EQ(chain_frame(bench, 1, 1), "a:run b:run");
}

TEST(FrameGraphReuse, APassWithoutKeysAlwaysRunsAndSoDoesWhatFollows) {
    TestBench bench;
    chain_frame(bench, {}, 1);
    EXPECT_EQ(chain_frame(bench, {}, 1), "a:run b:run");
    chain_frame(bench, 1, {});
    EXPECT_EQ(chain_frame(bench, 1, {}), "a:reused b:run");
}

// a -> [x1] -> b(key) -> [x2] -> c -> [x3]      x3 is required
TEST(FrameGraphReuse, AllWritersOfATextureRunOrNone) {
    TestBench bench;
    const auto frame = [&](std::uint64_t ka, std::uint64_t kb, std::uint64_t kc) {
        bench.pass({.name = "a", .creates = {"x"}, .key = ka});
        bench.pass({.name = "b", .writes = {"x"}, .key = kb});
        bench.pass({.name = "c", .writes = {"x"}, .key = kc});
        bench.require("x");
        return bench.run();
    };
    EXPECT_EQ(frame(1, 1, 1), "a:run b:run c:run");
    EXPECT_EQ(frame(1, 1, 1), "a:reused b:reused c:reused");
    EXPECT_EQ(frame(1, 2, 1), "a:run b:run c:run") << "b's background is spoiled, c's too";
    EXPECT_EQ(frame(1, 2, 2), "a:run b:run c:run") << "all before c are spoiled";
    EXPECT_EQ(frame(2, 2, 2), "a:run b:run c:run") << "all behind a are spoiled";
}

// a -> [x1][p1]
// b: [x1] -> [x2]        c(key): [p1] -> [p2]      x2 and p2 are required: a joins the two chains
TEST(FrameGraphReuse, APassWithTwoTexturesTiesTheirWriters) {
    TestBench bench;
    const auto frame = [&](std::uint64_t kc) {
        bench.pass({.name = "a", .creates = {"x", "p"}, .key = 1});
        bench.pass({.name = "b", .writes = {"x"}, .key = 1});
        bench.pass({.name = "c", .writes = {"p"}, .key = kc});
        bench.require("x");
        bench.require("p");
        return bench.run();
    };
    frame(1);
    EXPECT_EQ(frame(1), "a:reused b:reused c:reused");
    EXPECT_EQ(frame(2), "a:run b:run c:run") << "c needs p1 anew, so a runs, which spoils x, so b runs";
}

// a -> [x1] -> b -> [x2]
//        +---> r(key) -> [y]      r reads what b then writes over
TEST(FrameGraphReuse, AReaderOfAnIntermediateVersionHasItMadeAgain) {
    TestBench bench;
    const auto frame = [&](std::uint64_t kr) {
        bench.pass({.name = "a", .creates = {"x"}, .key = 1});
        bench.pass({.name = "r", .creates = {"y"}, .reads = {"x"}, .key = kr});
        bench.pass({.name = "b", .writes = {"x"}, .key = 1});
        bench.require("x");
        bench.require("y");
        return bench.run();
    };
    frame(1);
    EXPECT_EQ(frame(1), "a:reused r:reused b:reused");
    EXPECT_EQ(frame(2), "a:run r:run b:run");
}

// a -> [x1] -> b -> [x2] -> r(key) -> [y]      what the texture still holds need not be made again
TEST(FrameGraphReuse, AReaderOfTheLastVersionFindsIt) {
    TestBench bench;
    const auto frame = [&](std::uint64_t kr) {
        bench.pass({.name = "a", .creates = {"x"}, .key = 1});
        bench.pass({.name = "b", .writes = {"x"}, .key = 1});
        bench.pass({.name = "r", .creates = {"y"}, .reads = {"x"}, .key = kr});
        bench.require("y");
        return bench.run();
    };
    frame(1);
    EXPECT_EQ(frame(2), "a:reused b:reused r:run");
}

// a -> [x1] -> b -> [x2]      b's version is wanted in some frames only
TEST(FrameGraphReuse, AVersionThatIsNoLongerInTheTextureIsMadeAgain) {
    TestBench bench;
    const auto frame = [&](bool wants_b) {
        bench.pass({.name = "a", .creates = {"x"}, .key = 1});
        if (!wants_b) bench.require("x");
        bench.pass({.name = "b", .writes = {"x"}, .key = 1});
        if (wants_b) bench.require("x");
        return bench.run();
    };
    EXPECT_EQ(frame(true), "a:run b:run");
    EXPECT_EQ(frame(false), "a:run b:culled") << "x holds b's result";
    EXPECT_EQ(frame(false), "a:reused b:culled");
    EXPECT_EQ(frame(true), "a:run b:run");
}

// a -> [x1] -> b -> [x2]      one writer without keys: the whole texture is transient
TEST(FrameGraphReuse, OneUnkeyedWriterMakesTheTextureTransient) {
    TestBench bench;
    const auto frame = [&](std::optional<std::uint64_t> kb) {
        bench.pass({.name = "a", .creates = {"x"}, .key = 1});
        bench.pass({.name = "b", .writes = {"x"}, .key = kb});
        bench.require("x");
        return bench.run();
    };
    frame(1);
    EXPECT_GT(bench.graph.memory().kept_bytes, 0u);
    EXPECT_EQ(frame({}), "a:run b:run");
    EXPECT_EQ(bench.graph.memory().kept_bytes, 0u);
    EXPECT_EQ(bench.backend.created(), 1u) << "the kept texture went through the pool";
    EXPECT_EQ(frame(1), "a:run b:run");
    EXPECT_EQ(frame(1), "a:reused b:reused");
}

TEST(FrameGraphReuse, ACulledPassKeepsItsResultForAFewFrames) {
    TestBench bench;
    const auto frame = [&](bool wanted) {
        bench.pass({.name = "a", .creates = {"x"}, .key = 1});
        if (wanted) bench.require("x");
        return bench.run();
    };
    for (std::uint32_t pause = 1; pause < 2 * FrameGraph::idle_frames; ++pause) {
        frame(true);
        for (std::uint32_t i = 0; i < pause; ++i) EXPECT_EQ(frame(false), "a:culled");
        EXPECT_EQ(frame(true), pause < FrameGraph::idle_frames ? "a:reused" : "a:run") << pause;
    }
}

TEST(FrameGraphReuse, AnotherShapeOrNameIsAnotherResult) {
    TestBench bench;
    const auto frame = [&](TextureDesc desc, const std::string& pass, const std::string& texture) {
        bench.pass({.name = pass, .creates = {texture}, .key = 1, .desc = desc});
        bench.require(texture);
        return bench.run();
    };
    TextureDesc wide = small;
    wide.width *= 2;
    frame(small, "a", "x");
    EXPECT_EQ(frame(wide, "a", "x"), "a:run");
    EXPECT_EQ(frame(wide, "b", "x"), "b:run");
    EXPECT_EQ(frame(wide, "b", "y"), "b:run");
    EXPECT_EQ(frame(wide, "b", "y"), "b:reused");
}

// a -> [x] -> b -> [y]      b sees the shape of x, whichever part of it changes
TEST(FrameGraphReuse, AReaderDependsOnTheShapeOfItsInput) {
    TestBench bench;
    TextureDesc shape = small;
    const auto frame = [&] {
        bench.pass({.name = "a", .creates = {"x"}, .key = 1, .desc = shape});
        bench.pass({.name = "b", .creates = {"y"}, .reads = {"x"}, .key = 1});
        bench.require("y");
        return bench.run();
    };
    frame();
    const auto expect_run = [&] {
        EXPECT_EQ(frame(), "a:run b:run");
        EXPECT_EQ(frame(), "a:reused b:reused");
    };
    shape.width = 16, expect_run();
    shape.height = 8, expect_run();
    shape.format = Format::r32f, expect_run();
    shape.levels = 2, expect_run();
    shape.levels = 1, shape.samples = 2, expect_run();
}

// a -> [x][y], then a -> [y][x]      what was drawn into the first is now drawn into the second
TEST(FrameGraphReuse, TheOrderOfTheTexturesCounts) {
    TestBench bench;
    const auto frame = [&](const std::string& first, const std::string& second) {
        bench.pass({.name = "a", .creates = {first, second}, .key = 1});
        bench.require(first);
        return bench.run();
    };
    frame("x", "y");
    EXPECT_EQ(frame("y", "x"), "a:run");
}

// a -> [x] -> save(key, side effect)
TEST(FrameGraphReuse, ASideEffectIsDoneAgainWhenSomethingChanged) {
    TestBench bench;
    const auto frame = [&](std::uint64_t ka, std::uint64_t ks) {
        bench.pass({.name = "a", .creates = {"x"}, .key = ka});
        bench.pass({.name = "save", .reads = {"x"}, .key = ks, .side_effect = true});
        return bench.run();
    };
    EXPECT_EQ(frame(1, 1), "a:run save:run");
    EXPECT_EQ(frame(1, 1), "a:reused save:reused");
    EXPECT_EQ(frame(1, 2), "a:reused save:run");
    EXPECT_EQ(frame(2, 2), "a:run save:run");
    EXPECT_EQ(frame(2, 2), "a:reused save:reused");
}

TEST(FrameGraphReuse, ForgettingRunsAllThatIsNeeded) {
    TestBench bench;
    chain_frame(bench, 1, 1);
    bench.graph.forget_results();
    EXPECT_EQ(chain_frame(bench, 1, 1), "a:run b:run");
    EXPECT_EQ(chain_frame(bench, 1, 1), "a:reused b:reused");
    EXPECT_EQ(bench.backend.created(), 2u) << "the textures stay, only what is in them does not count";
}

} // namespace
} // namespace hachure::gpu::testing
