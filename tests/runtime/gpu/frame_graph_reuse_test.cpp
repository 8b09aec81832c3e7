#include <hachure/runtime/error.h>

#include <gtest/gtest.h>

#include "frame_graph_bench.h"

namespace hachure::gpu::testing {
namespace {

// a(ka) -> [x] -> b(kb) -> [y]      y is required
std::string chain_frame(TestBench& bench, std::optional<std::uint64_t> ka, std::optional<std::uint64_t> kb) {
    bench.pass({.name = "a", .creates = {"x"}, .key = ka});
    bench.pass({.name = "b", .creates = {"y"}, .reads = {"x"}, .key = kb});
    bench.require("y");
    return bench.run();
}

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

TEST(FrameGraphReuse, AnImportedTargetKeepsItsResultsIfItsOwnerSaysSo) {
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
TEST(FrameGraphReuse, ReadersOfAnImportedTextureDependOnItsContents) {
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

TEST(FrameGraphReuse, ForgettingRunsAllThatIsNeeded) {
    TestBench bench;
    chain_frame(bench, 1, 1);
    bench.graph.forget_results();
    EXPECT_EQ(chain_frame(bench, 1, 1), "a:run b:run");
    EXPECT_EQ(chain_frame(bench, 1, 1), "a:reused b:reused");
    EXPECT_EQ(bench.backend.created(), 2u) << "the textures stay, only what is in them does not count";
}

TEST(FrameGraphReuse, AFrameWithoutExecutionChangesNothing) {
    TestBench bench;
    chain_frame(bench, 1, 1);
    bench.pass({.name = "a", .creates = {"x"}, .key = 2});
    bench.require("x");
    bench.graph.compile();
    bench.begin();
    EXPECT_EQ(chain_frame(bench, 1, 1), "a:reused b:reused");
}

// a -> [x] -> b -> [y], b fails
TEST(FrameGraphReuse, AFailedPassIsRunAgainAndWhatWasFinishedStands) {
    TestBench bench;
    const auto frame = [&](std::uint64_t kb, bool fails) {
        bench.pass({.name = "a", .creates = {"x"}, .key = 1});
        bench.pass({.name = "b", .creates = {"y"}, .reads = {"x"}, .key = kb, .also = [fails](PassContext&) {
                        if (fails) throw Error("no more ink");
                    }});
        bench.require("y");
        return bench.run();
    };
    frame(1, false);
    EXPECT_THROW(frame(2, true), Error);
    EXPECT_FALSE(bench.backend.in_pass());
    EXPECT_THROW(bench.graph.execute(), FrameGraphError) << "only begin_frame() may follow";
    bench.begin();
    EXPECT_EQ(frame(2, false), "a:reused b:run");
    bench.begin();
    EXPECT_THROW(frame(3, true), Error);
    bench.begin();
    EXPECT_EQ(frame(2, false), "a:reused b:run") << "b had begun to write over it";
}

TEST(FrameGraphReuse, ARefusedTextureIsAskedForAgain) {
    TestBench bench;
    bench.backend.fail_creation_after(1);
    EXPECT_THROW(chain_frame(bench, 1, 1), Error);
    bench.backend.allow_creation();
    bench.begin();
    EXPECT_EQ(chain_frame(bench, 1, 1), "a:reused b:run");
    EXPECT_EQ(bench.backend.alive(), 2u);
}

} // namespace
} // namespace hachure::gpu::testing
