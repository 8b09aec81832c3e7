#include <hachure/runtime/error.h>

#include <gtest/gtest.h>

#include "frame_graph_bench.h"

namespace hachure::gpu::testing {
namespace {

// a(ka) -> [x] -> b(kb) -> [y]      y is required
TEST(FrameGraphFailure, AFrameWithoutExecutionChangesNothing) {
    TestBench bench;
    chain_frame(bench, 1, 1);
    bench.pass({.name = "a", .creates = {"x"}, .key = 2});
    bench.require("x");
    bench.graph.compile();
    bench.begin();
    EXPECT_EQ(chain_frame(bench, 1, 1), "a:reused b:reused");
}

// a -> [x] -> b -> [y], b fails
TEST(FrameGraphFailure, AFailedPassIsRunAgainAndWhatWasFinishedStands) {
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

TEST(FrameGraphFailure, AFailedSideEffectIsNotDone) {
    TestBench bench;
    const auto frame = [&](std::uint64_t key, bool fails) {
        bench.begin();
        bench.pass({.name = "save", .key = key, .side_effect = true, .also = [fails](PassContext&) {
                        if (fails) throw Error("disk full");
                    }});
        return bench.run_only();
    };
    frame(1, false);
    EXPECT_THROW(frame(2, true), Error);
    EXPECT_EQ(frame(1, false), "save:run") << "the failure may have spoiled what was there";
}

TEST(FrameGraphFailure, ARefusedTextureIsAskedForAgain) {
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
