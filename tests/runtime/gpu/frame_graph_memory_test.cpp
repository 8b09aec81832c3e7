#include <hachure/runtime/error.h>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "frame_graph_bench.h"

namespace hachure::gpu::testing {
namespace {

TextureDesc sized(int width, int height) { return {.width = width, .height = height, .format = Format::rgba8}; }

// a -> [x] -> b -> [y] -> c -> [z] -> d -> [w]      x is free when z is made, y when w is
TEST(FrameGraphMemory, AChainOfTransientsTakesTwoTextures) {
    TestBench bench;
    bench.pass({.name = "a", .creates = {"x"}});
    bench.pass({.name = "b", .creates = {"y"}, .reads = {"x"}});
    bench.pass({.name = "c", .creates = {"z"}, .reads = {"y"}});
    bench.pass({.name = "d", .creates = {"w"}, .reads = {"z"}});
    bench.require("w");
    bench.run_only();
    const FrameGraphMemory memory = bench.graph.memory();
    EXPECT_EQ(memory.textures, 2u);
    EXPECT_EQ(memory.physical_bytes, 2u * 64 * 32 * 4);
    EXPECT_EQ(memory.unshared_bytes, 4u * 64 * 32 * 4);
    EXPECT_EQ(memory.kept_bytes, 0u);
    EXPECT_EQ(bench.backend.alive_bytes(), memory.physical_bytes);
}

// a -> [x] -> b -> [y], and [x] -> c      x lives until c, so y can't have its place, and z can't have y's
TEST(FrameGraphMemory, ATextureIsHeldUntilItsLastReader) {
    TestBench bench;
    bench.pass({.name = "a", .creates = {"x"}});
    bench.pass({.name = "b", .creates = {"y"}, .reads = {"x"}});
    bench.pass({.name = "c", .creates = {"z"}, .reads = {"x", "y"}});
    bench.require("z");
    bench.run_only();
    EXPECT_EQ(bench.graph.memory().textures, 3u);
}

TEST(FrameGraphMemory, OtherShapesDoNotShare) {
    TestBench bench;
    bench.pass({.name = "a", .creates = {"x"}, .desc = sized(8, 8)});
    bench.pass({.name = "b", .creates = {"y"}, .reads = {"x"}, .desc = sized(8, 8)});
    bench.pass({.name = "c", .creates = {"z"}, .reads = {"y"}, .desc = sized(8, 9)});
    bench.require("z");
    bench.run_only();
    EXPECT_EQ(bench.graph.memory().textures, 3u);
}

// a -> [x]      b -> [y]      x is required, so what it holds must outlast the frame
TEST(FrameGraphMemory, ARequiredTransientIsHeldUntilTheNextFrame) {
    TestBench bench;
    bench.pass({.name = "a", .creates = {"x"}});
    bench.pass({.name = "b", .creates = {"y"}});
    bench.require("x");
    bench.require("y");
    bench.run_only();
    EXPECT_NE(bench.graph.texture(bench.newest["x"]), bench.graph.texture(bench.newest["y"]));
    EXPECT_EQ(bench.backend.alive(), 2u);
}

TEST(FrameGraphMemory, KeptTexturesAreNotShared) {
    TestBench bench;
    for (std::uint64_t frame = 0; frame < 3; ++frame) {
        bench.pass({.name = "a", .creates = {"x"}, .key = 1});
        bench.pass({.name = "b", .creates = {"y"}, .reads = {"x"}, .key = frame});
        bench.pass({.name = "c", .creates = {"z"}, .reads = {"y"}});
        bench.require("z");
        bench.run();
    }
    EXPECT_EQ(bench.graph.memory().textures, 3u);
    EXPECT_EQ(bench.graph.memory().kept_bytes, 2u * 64 * 32 * 4);
}

TEST(FrameGraphMemory, SteadyFramesCreateNothing) {
    TestBench bench;
    std::size_t created = 0;
    for (std::uint64_t frame = 0; frame < 1000; ++frame) {
        bench.pass({.name = "a", .creates = {"x"}, .key = frame / 3});
        bench.pass({.name = "b", .creates = {"y"}, .reads = {"x"}});
        bench.pass({.name = "c", .creates = {"z"}, .reads = {"y"}});
        bench.require("z");
        bench.run();
        if (frame == 0) created = bench.backend.created();
    }
    EXPECT_EQ(bench.backend.created(), created);
    EXPECT_EQ(bench.backend.destroyed(), 0u);
}

TEST(FrameGraphMemory, ResizingEveryFrameStaysBounded) {
    TestBench bench;
    std::size_t most = 0;
    for (int frame = 0; frame < 1000; ++frame) {
        const TextureDesc desc = sized(100 + frame, 100);
        bench.pass({.name = "a", .creates = {"x"}, .key = 1, .desc = desc});
        bench.pass({.name = "b", .creates = {"y"}, .reads = {"x"}, .desc = desc});
        bench.require("y");
        bench.run();
        most = std::max(most, bench.backend.alive());
    }
    EXPECT_LE(most, 2u * (1 + FrameGraph::idle_frames));
    // The window stays as it is now: only its two textures remain.
    for (std::uint32_t frame = 0; frame < FrameGraph::idle_frames; ++frame) {
        bench.pass({.name = "a", .creates = {"x"}, .key = 1, .desc = sized(1099, 100)});
        bench.pass({.name = "b", .creates = {"y"}, .reads = {"x"}, .desc = sized(1099, 100)});
        bench.require("y");
        bench.run();
    }
    EXPECT_EQ(bench.backend.alive(), 2u);
    EXPECT_EQ(bench.graph.memory().physical_bytes, bench.backend.alive_bytes());
}

TEST(FrameGraphMemory, WhatIsNoLongerDeclaredIsGivenBack) {
    TestBench bench;
    bench.pass({.name = "a", .creates = {"x"}, .key = 1});
    bench.pass({.name = "b", .creates = {"y"}});
    bench.require("x");
    bench.require("y");
    bench.run();
    for (std::uint32_t frame = 0; frame < 2 * FrameGraph::idle_frames; ++frame) {
        EXPECT_GT(bench.backend.alive(), 0u);
        bench.run();
    }
    EXPECT_EQ(bench.backend.alive(), 0u);
}

TEST(FrameGraphMemory, NamesThatChangeInEveryFrameStayBounded) {
    TestBench bench;
    std::size_t most = 0;
    for (int frame = 0; frame < 1000; ++frame) {
        bench.pass({.name = fmt::format("a{}", frame), .creates = {fmt::format("x{}", frame)}, .key = 1});
        bench.require(fmt::format("x{}", frame));
        bench.run();
        most = std::max(most, bench.backend.alive());
    }
    EXPECT_LE(most, 2u * (1 + FrameGraph::idle_frames));
}

TEST(FrameGraphMemory, FailingFramesStayBounded) {
    TestBench bench;
    for (int frame = 0; frame < 100; ++frame) {
        bench.pass({.name = "a", .creates = {"x"}, .desc = sized(1 + frame, 1)});
        bench.pass({.name = "b",
                    .creates = {"y"},
                    .reads = {"x"},
                    .key = 1,
                    .desc = sized(1 + frame, 2),
                    .also = [](PassContext&) { throw Error("told to fail"); }});
        bench.require("y");
        EXPECT_THROW(bench.run_only(), Error);
        bench.begin();
    }
    EXPECT_LE(bench.backend.alive(), 2u * (2 + FrameGraph::idle_frames));
}

TEST(FrameGraphMemory, TheGraphGivesEverythingBack) {
    NullBackend backend;
    {
        FrameGraph graph(backend);
        graph.begin_frame();
        const auto& x = graph.add_pass<TextureHandle>(
            "a", [](PassBuilder& pass, TextureHandle& texture) { texture = pass.create("x", small); },
            [](const TextureHandle&, PassContext&) {});
        graph.require(x);
        graph.run();
        FrameGraph moved = std::move(graph);
        EXPECT_EQ(backend.alive(), 1u);
    }
    EXPECT_EQ(backend.alive(), 0u);
    EXPECT_EQ(backend.destroyed(), backend.created());
}

// Random passes, each with one output, reading some earlier ones: no texture is in the place of one that is still read.
TEST(FrameGraphMemory, NoTwoThatLiveAtOnceShare) {
    std::mt19937 random(7);
    std::size_t unshared = 0, physical = 0;
    for (int round = 0; round < 200; ++round) {
        TestBench bench;
        const std::size_t count = 2 + random() % 20;
        std::vector<std::size_t> last_use(count);
        std::vector<std::uint32_t> ids(count);
        for (std::size_t i = 0; i < count; ++i) {
            PassSpec pass{.name = fmt::format("p{}", i), .creates = {fmt::format("t{}", i)}};
            pass.side_effect = true; // so that nothing is culled
            pass.desc.width = random() % 3 ? 64 : 32;
            last_use[i] = i;
            for (std::size_t j = i > 6 ? i - 6 : 0; j < i; ++j) {
                if (random() % 4) continue;
                pass.reads.push_back(fmt::format("t{}", j));
                last_use[j] = i;
            }
            pass.also = [&bench, &ids, i](PassContext& context) {
                ids[i] = context.texture(bench.newest[fmt::format("t{}", i)]);
            };
            bench.pass(std::move(pass));
        }
        bench.run_only();
        for (std::size_t i = 0; i < count; ++i) {
            for (std::size_t j = i + 1; j <= last_use[i]; ++j) EXPECT_NE(ids[i], ids[j]) << i << ' ' << j;
        }
        unshared += bench.graph.memory().unshared_bytes;
        physical += bench.graph.memory().physical_bytes;
    }
    EXPECT_LT(physical * 10, unshared * 8) << "sharing saves something";
}

} // namespace
} // namespace hachure::gpu::testing
