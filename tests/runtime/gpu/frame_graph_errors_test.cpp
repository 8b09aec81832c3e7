#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "frame_graph_bench.h"

namespace hachure::gpu::testing {
namespace {

/// What the FrameGraphError says that `wrong` throws.
template <class Wrong> std::string fault_of(Wrong&& wrong) {
    try {
        wrong();
    } catch (const FrameGraphError& error) {
        return error.what();
    }
    return "nothing was thrown";
}

TEST(FrameGraphErrors, ReadingWhatNobodyWrote) {
    TestBench bench;
    EXPECT_EQ(fault_of([&] { bench.pass({.name = "b", .reads = {"missing"}}); }),
              "pass 'b' reads an empty handle: no pass has written that texture");
    bench.begin();
    bench.import("window", 1000);
    EXPECT_EQ(fault_of([&] { bench.pass({.name = "b", .reads = {"window"}}); }),
              "pass 'b' reads 'window', which no pass has written");
}

// a -> [x1] -> b -> [x2], and then c uses x1
TEST(FrameGraphErrors, UsingAVersionThatWasWrittenOver) {
    const auto with_stale_handle = [](bool write) {
        TestBench bench;
        bench.pass({.name = "a", .creates = {"x"}});
        const TextureHandle stale = bench.newest["x"];
        bench.pass({.name = "b", .writes = {"x"}});
        bench.newest["x"] = stale;
        const std::vector<std::string> x{"x"}, none;
        return fault_of([&] { bench.pass({.name = "c", .reads = write ? none : x, .writes = write ? x : none}); });
    };
    EXPECT_EQ(with_stale_handle(false), "pass 'c' reads version 1 of 'x', which pass 'b' has replaced by version 2");
    EXPECT_EQ(with_stale_handle(true), "pass 'c' writes version 1 of 'x', which pass 'b' has replaced by version 2");
}

TEST(FrameGraphErrors, TwoTexturesOfOneName) {
    TestBench bench;
    bench.pass({.name = "a", .creates = {"x"}});
    EXPECT_EQ(fault_of([&] { bench.pass({.name = "b", .creates = {"x"}}); }),
              "pass 'b' creates 'x', which pass 'a' creates already");
    bench.begin();
    bench.import("x", 1000);
    EXPECT_EQ(fault_of([&] { bench.pass({.name = "b", .creates = {"x"}}); }),
              "pass 'b' creates 'x', which was imported already");
    bench.begin();
    bench.import("x", 1000);
    EXPECT_EQ(fault_of([&] { bench.import("y", 1000); }), "the frame imports texture 1000 both as 'x' and as 'y'");
}

TEST(FrameGraphErrors, TwoPassesOfOneName) {
    TestBench bench;
    bench.pass({.name = "a"});
    EXPECT_EQ(fault_of([&] { bench.pass({.name = "a"}); }), "two passes are called 'a'");
}

TEST(FrameGraphErrors, ReadingAndWritingAtOnce) {
    TestBench bench;
    bench.pass({.name = "a", .creates = {"x"}});
    EXPECT_EQ(fault_of([&] { bench.pass({.name = "b", .reads = {"x"}, .writes = {"x"}}); }),
              "pass 'b' writes 'x', which it also reads or writes");
    const auto in_setup = [&](auto setup) {
        return fault_of([&] {
            bench.begin();
            bench.graph.add_pass<int>(
                "c", [&](PassBuilder& pass, int&) { setup(pass); }, [](const int&, PassContext&) {});
        });
    };
    EXPECT_EQ(in_setup([](PassBuilder& pass) { pass.read(pass.create("x", small)); }),
              "pass 'c' reads 'x', which it also writes");
    EXPECT_EQ(in_setup([](PassBuilder& pass) { pass.write(pass.create("x", small)); }),
              "pass 'c' writes 'x', which it also creates");
}

TEST(FrameGraphErrors, ExecutingWithWhatWasNotDeclared) {
    TestBench bench;
    const auto uses = [&](const std::string& name) {
        return [&bench, name](PassContext& context) { static_cast<void>(context.texture(bench.newest[name])); };
    };
    bench.pass({.name = "a", .creates = {"x"}});
    bench.pass({.name = "b", .creates = {"y"}, .also = uses("x")});
    bench.require("y");
    EXPECT_EQ(fault_of([&] { bench.run_only(); }), "pass 'b' uses 'x', which it has not declared");

    bench.begin();
    bench.pass({.name = "a", .creates = {"x"}, .also = uses("x")}); // by then the newest is b's
    bench.pass({.name = "b", .writes = {"x"}});
    bench.require("x");
    EXPECT_EQ(fault_of([&] { bench.run_only(); }), "pass 'a' uses version 2 of 'x', but has declared version 1");

    bench.begin();
    bench.pass({.name = "a", .creates = {"x"}, .also = uses("nothing")});
    bench.require("x");
    EXPECT_EQ(fault_of([&] { bench.run_only(); }), "pass 'a' uses an empty handle: no pass has written that texture");
}

TEST(FrameGraphErrors, HandlesOfAnotherFrameOrGraph) {
    TestBench bench, other;
    bench.pass({.name = "a", .creates = {"x"}});
    const TextureHandle old = bench.newest["x"];
    bench.begin();
    bench.newest["x"] = old;
    EXPECT_EQ(fault_of([&] { bench.pass({.name = "b", .reads = {"x"}}); }),
              "pass 'b' reads a handle of another frame or graph");
    EXPECT_EQ(fault_of([&] { other.graph.require(old); }), "the frame requires a handle of another frame or graph");
    EXPECT_EQ(fault_of([&] { other.graph.publish("x", old); }),
              "the frame publishes a handle of another frame or graph");
    EXPECT_EQ(fault_of([&] { static_cast<void>(other.graph.desc(old)); }),
              "desc() of a handle of another frame or graph");
}

// a -> [x1, required] -> b -> [x2, required by a reader]
TEST(FrameGraphErrors, RequiringWhatIsWrittenOver) {
    TestBench bench;
    bench.pass({.name = "a", .creates = {"x"}});
    bench.require("x");
    bench.pass({.name = "b", .writes = {"x"}, .side_effect = true});
    EXPECT_EQ(fault_of([&] { bench.graph.compile(); }),
              "the frame requires version 1 of 'x', which pass 'b' writes over");
    bench.begin();
    bench.pass({.name = "a", .creates = {"x"}});
    bench.require("x");
    bench.pass({.name = "b", .writes = {"x"}});
    EXPECT_EQ(fault_of([&] { bench.require("x"); }), "the frame requires both version 1 and version 2 of 'x'");
    bench.begin();
    bench.import("window", 1000);
    EXPECT_EQ(fault_of([&] { bench.require("window"); }), "the frame requires 'window', which no pass has written");
}

TEST(FrameGraphErrors, ShapesThatNoTextureHas) {
    const auto fault = [](TextureDesc desc) {
        TestBench bench;
        return fault_of([&] { bench.pass({.name = "a", .creates = {"x"}, .desc = desc}); });
    };
    EXPECT_EQ(fault({.width = 0, .height = 4}), "pass 'a' creates 'x' with size 0x4");
    EXPECT_EQ(fault({.width = 4, .height = -1}), "pass 'a' creates 'x' with size 4x-1");
    EXPECT_EQ(fault({.width = 4, .height = 4, .levels = 4}), "pass 'a' creates 'x' with 4 levels at size 4x4");
    EXPECT_EQ(fault({.width = 4, .height = 4, .levels = 3}), "nothing was thrown");
    EXPECT_EQ(fault({.width = 4, .height = 4, .levels = 0}), "pass 'a' creates 'x' with 0 levels at size 4x4");
    EXPECT_EQ(fault({.width = 4, .height = 4, .samples = 0}), "pass 'a' creates 'x' with 0 samples");
    EXPECT_EQ(fault({.width = 4, .height = 4, .levels = 2, .samples = 4}),
              "pass 'a' creates 'x' with both samples and levels");
}

TEST(FrameGraphErrors, CallsOutOfOrder) {
    TestBench bench;
    EXPECT_THAT(fault_of([&] { bench.graph.execute(); }), ::testing::StartsWith("execute() out of order"));
    bench.graph.compile();
    EXPECT_THAT(fault_of([&] { bench.pass({.name = "a"}); }), ::testing::StartsWith("add_pass('a') out of order"));
    EXPECT_THAT(fault_of([&] { bench.graph.compile(); }), ::testing::StartsWith("compile() out of order"));
    bench.graph.execute();
    EXPECT_THAT(fault_of([&] { bench.graph.execute(); }), ::testing::StartsWith("execute() out of order"));
    bench.begin();
    const std::string nested = fault_of([&] {
        bench.graph.add_pass<int>(
            "outer", [&](PassBuilder&, int&) { bench.pass({.name = "inner"}); }, [](const int&, PassContext&) {});
    });
    EXPECT_EQ(nested, "add_pass('inner') during or after a failure of the setup of pass 'outer'");
}

// a -> [x] -> b -> [y]      only y is required
TEST(FrameGraphErrors, AskingForATextureThatIsNotThereAfterwards) {
    TestBench bench;
    bench.pass({.name = "a", .creates = {"x"}});
    bench.pass({.name = "b", .creates = {"y"}, .reads = {"x"}});
    bench.require("y");
    EXPECT_THAT(fault_of([&] { static_cast<void>(bench.graph.texture(bench.newest["y"])); }),
                ::testing::StartsWith("texture() out of order"));
    bench.run_only();
    EXPECT_EQ(fault_of([&] { static_cast<void>(bench.graph.texture(bench.newest["x"])); }),
              "texture() of version 1 of 'x', which is not required");
    EXPECT_NE(bench.graph.texture(bench.newest["y"]), 0u);
}

} // namespace
} // namespace hachure::gpu::testing
