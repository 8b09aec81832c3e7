#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "frame_graph_bench.h"

namespace hachure::gpu::testing {
namespace {

// a -> [x][big] -> b -> [y]      c -> [z] is not needed
TEST(FrameGraphStats, PixelsAndBytes) {
    TestBench bench;
    TextureDesc deep{.width = 10, .height = 20, .format = Format::rgba32f, .levels = 2};
    bench.pass({.name = "a", .creates = {"x"}});
    bench.pass({.name = "b", .creates = {"y"}, .reads = {"x"}, .desc = deep});
    bench.pass({.name = "c", .creates = {"z"}});
    bench.require("y");
    bench.run_only();
    const auto stats = bench.graph.stats();
    ASSERT_EQ(stats.size(), 3u);
    EXPECT_EQ(stats[0].name, "a");
    EXPECT_EQ(stats[0].pixels, 64u * 32);
    EXPECT_EQ(stats[0].bytes, 64u * 32 * 4);
    EXPECT_EQ(stats[1].pixels, 10u * 20);
    EXPECT_EQ(stats[1].bytes, 64u * 32 * 4 + (10 * 20 + 5 * 10) * 16u);
    EXPECT_EQ(stats[2].state, PassState::culled);
    EXPECT_EQ(stats[2].pixels, 0u);
    EXPECT_EQ(stats[2].bytes, 0u);
    EXPECT_EQ(stats[2].cpu_ms, 0.0);
    EXPECT_FALSE(stats[2].gpu_ms);
}

TEST(FrameGraphStats, PixelsThatAPassDeclaresOrFinds) {
    TestBench bench;
    const auto frame = [&](std::optional<std::uint64_t> found) {
        const auto& x = bench.graph.add_pass<TextureHandle>(
            "a",
            [](PassBuilder& pass, TextureHandle& texture) {
                texture = pass.create("x", small);
                pass.covers(100);
            },
            [=](const TextureHandle&, PassContext& context) {
                if (found) context.set_pixels(*found);
            });
        bench.graph.require(x);
        bench.graph.run();
        const std::uint64_t pixels = bench.graph.stats()[0].pixels;
        bench.begin();
        return pixels;
    };
    EXPECT_EQ(frame({}), 100u);
    EXPECT_EQ(frame(7), 7u);
}

TEST(FrameGraphStats, CpuTimeIsThatOfThePass) {
    TestBench bench;
    bench.pass({.name = "a", .creates = {"x"}, .also = [](PassContext&) {
                    std::this_thread::sleep_for(std::chrono::milliseconds(5));
                }});
    bench.pass({.name = "b", .creates = {"y"}, .reads = {"x"}});
    bench.require("y");
    bench.run_only();
    EXPECT_GE(bench.graph.stats()[0].cpu_ms, 5.0);
    EXPECT_LT(bench.graph.stats()[1].cpu_ms, bench.graph.stats()[0].cpu_ms);
}

TEST(FrameGraphStats, GpuTimesArriveLater) {
    TestBench bench;
    bench.backend.delay_timers(true);
    const auto frame = [&](double milliseconds) {
        bench.begin();
        bench.backend.set_gpu_ms(milliseconds);
        bench.pass({.name = "a", .creates = {"x"}});
        bench.require("x");
        bench.run_only();
        return bench.graph.stats()[0].gpu_ms;
    };
    EXPECT_FALSE(frame(1.5)) << "still under way";
    EXPECT_FALSE(frame(2.5));
    bench.graph.finish();
    EXPECT_EQ(bench.graph.stats()[0].gpu_ms, 2.5);
    EXPECT_EQ(bench.backend.pending_timers(), 0u);
    EXPECT_EQ(frame(3.5), 2.5) << "the latest known one";
    bench.backend.delay_timers(false);
    frame(4.5);
    bench.graph.finish();
    EXPECT_EQ(bench.graph.stats()[0].gpu_ms, 4.5);
}

TEST(FrameGraphStats, GpuTimesOfABackEndWithoutClocks) {
    TestBench bench;
    bench.backend.set_gpu_ms({});
    bench.pass({.name = "a", .creates = {"x"}});
    bench.require("x");
    bench.run_only();
    bench.graph.finish();
    EXPECT_FALSE(bench.graph.stats()[0].gpu_ms);
}

TEST(FrameGraphStats, AReusedPassHasNoCosts) {
    TestBench bench;
    for (int frame = 0; frame < 2; ++frame) {
        bench.begin();
        bench.pass({.name = "a", .creates = {"x"}, .key = 1});
        bench.require("x");
        bench.run_only();
        bench.graph.finish();
    }
    const PassStats& stats = bench.graph.stats()[0];
    EXPECT_EQ(stats.state, PassState::reused);
    EXPECT_EQ(stats.cpu_ms, 0.0);
    EXPECT_EQ(stats.pixels, 0u);
    EXPECT_FALSE(stats.gpu_ms);
}

std::string draw(TestBench& bench, bool dot) {
    bench.import("window", 1000);
    bench.pass({.name = "gooch", .creates = {"color"}, .key = 1});
    bench.pass({.name = "lines", .writes = {"color"}, .key = 1});
    bench.pass({.name = "show", .reads = {"color"}, .writes = {"window"}});
    bench.require("window");
    bench.pass({.name = "unwanted \"one\"", .creates = {"x"}, .reads = {"color"}});
    bench.run_only();
    return dot ? bench.graph.describe_dot() : bench.graph.describe();
}

// gooch -> [color1] -> lines -> [color2] -> show -> [window1]
//                                   +-----> unwanted -> [x]
TEST(FrameGraphStats, TheGraphAsText) {
    TestBench bench;
    draw(bench, false);
    bench.begin();
    EXPECT_EQ(draw(bench, false), "gooch: reused\n"
                                  "  create color.1 64x32 rgba8 kept\n"
                                  "lines: reused\n"
                                  "  write color.1 -> color.2\n"
                                  "show: run\n"
                                  "  read color.2\n"
                                  "  write window.0 -> window.1\n"
                                  "unwanted \"one\": culled\n"
                                  "  read color.2\n"
                                  "  create x.1 64x32 rgba8 unused\n"
                                  "require window.1\n");
}

TEST(FrameGraphStats, TheGraphForGraphviz) {
    TestBench bench;
    EXPECT_EQ(draw(bench, true), "digraph frame {\n"
                                 "  rankdir=LR\n"
                                 "  \"pass gooch\" [shape=box label=\"gooch\nrun\"]\n"
                                 "  \"pass gooch\" -> \"color.1\"\n"
                                 "  \"pass lines\" [shape=box label=\"lines\nrun\"]\n"
                                 "  \"color.1\" -> \"pass lines\"\n"
                                 "  \"pass lines\" -> \"color.2\"\n"
                                 "  \"pass show\" [shape=box label=\"show\nrun\"]\n"
                                 "  \"color.2\" -> \"pass show\"\n"
                                 "  \"window.0\" -> \"pass show\"\n"
                                 "  \"pass show\" -> \"window.1\"\n"
                                 "  \"pass unwanted \\\"one\\\"\" [shape=box label=\"unwanted \\\"one\\\"\nculled\"]\n"
                                 "  \"color.2\" -> \"pass unwanted \\\"one\\\"\"\n"
                                 "  \"pass unwanted \\\"one\\\"\" -> \"x.1\"\n"
                                 "}\n");
}

} // namespace
} // namespace hachure::gpu::testing
