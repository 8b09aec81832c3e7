#include <hachure/runtime/gpu/frame_graph.h>
#include <hachure/runtime/gpu/frame_graph_null.h>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <limits>
#include <string>
#include <vector>

namespace hachure::gpu {
namespace {

/// A back end that does nothing at all, so that only the graph's own work is measured.
class IdleBackend final : public FrameGraphBackend {
public:
    std::uint32_t create_texture(const TextureDesc&, std::string_view) override { return ++last_; }
    void destroy_texture(std::uint32_t) override {}
    std::uint64_t begin_pass(std::string_view) override { return 1; }
    void end_pass() override {}
    std::optional<double> gpu_ms(std::uint64_t) override { return 1.0; }
    void finish() override {}

private:
    std::uint32_t last_ = 0;
};

constexpr int passes = 100;

struct Times {
    double declare_ms = std::numeric_limits<double>::max();
    double run_ms = std::numeric_limits<double>::max();
};

/// The best of many frames of 100 passes, each reading the results of two before it.
Times measure(bool keyed) {
    using Clock = std::chrono::steady_clock;
    IdleBackend backend;
    FrameGraph graph(backend);
    std::vector<std::string> names;
    for (int i = 0; i < passes; ++i) names.push_back(fmt::format("pass_with_a_name_{}", i));
    Times best;
    for (int frame = 0; frame < 300; ++frame) {
        const auto begin = Clock::now();
        graph.begin_frame();
        std::vector<TextureHandle> made;
        for (int i = 0; i < passes; ++i) {
            made.push_back(graph.add_pass<TextureHandle>(
                names[static_cast<std::size_t>(i)],
                [&](PassBuilder& pass, TextureHandle& texture) {
                    texture = pass.create(names[static_cast<std::size_t>(i)], {.width = 64, .height = 64});
                    for (int back = 1; back <= std::min(i, 2); ++back) {
                        pass.read(made[static_cast<std::size_t>(i - back)]);
                    }
                    if (keyed) pass.depends_on(i);
                },
                [](const TextureHandle& texture, PassContext& context) {
                    static_cast<void>(context.texture(texture));
                }));
        }
        graph.require(made.back());
        const auto declared = Clock::now();
        graph.run();
        const auto end = Clock::now();
        best.declare_ms =
            std::min(best.declare_ms, std::chrono::duration<double, std::milli>(declared - begin).count());
        best.run_ms = std::min(best.run_ms, std::chrono::duration<double, std::milli>(end - declared).count());
    }
    return best;
}

// The limit holds for an optimised build; the sanitizers' builds are several times slower.
#if defined(NDEBUG) && !defined(__SANITIZE_ADDRESS__)
constexpr double limit_ms = 0.1;
#else
constexpr double limit_ms = 10.0;
#endif

TEST(FrameGraphSpeed, AHundredPassesCostLessThanATenthOfAMillisecond) {
    for (const bool keyed : {false, true}) {
        const Times best = measure(keyed);
        std::printf("100 passes %s: declare %.4f ms, compile and execute %.4f ms\n", keyed ? "reused" : "run",
                    best.declare_ms, best.run_ms);
        EXPECT_LT(best.run_ms, limit_ms);
    }
}

} // namespace
} // namespace hachure::gpu
