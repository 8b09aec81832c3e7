#include <hachure/runtime/error.h>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "frame_graph_bench.h"

namespace hachure::gpu::testing {
namespace {

// Whatever the graph culls, reuses and shares, what can be seen of a frame is what running everything would give.

struct Import {
    std::string name;
    std::uint32_t id = 0;
    ImportOptions options;
};

struct Frame {
    std::vector<Import> imports;
    std::vector<PassSpec> passes;
    std::vector<std::string> required;
};

using Contents = std::map<std::string, std::uint64_t>;

/// The contents of every texture and what every side effect sees when all passes run, one after the other.
struct Reference {
    Contents textures;
    Contents effects;

    explicit Reference(const Frame& frame) {
        for (const Import& import : frame.imports) textures[import.name] = import.options.contents.value_or(0);
        for (const PassSpec& pass : frame.passes) {
            std::vector<std::uint64_t> inputs;
            for (const auto& name : pass.reads) inputs.push_back(textures.at(name));
            for (const auto& name : pass.writes) inputs.push_back(textures.at(name));
            if (pass.side_effect) effects[pass.name] = TestBench::result(pass, inputs, "effect");
            for (const auto& name : pass.writes) textures[name] = TestBench::result(pass, inputs, name);
            for (const auto& name : pass.creates) textures[name] = TestBench::result(pass, inputs, name);
        }
    }
};

/// Makes frames that resemble each other: a fixed cast of passes, of which keys, presence and wiring change at times.
class FrameMaker {
public:
    FrameMaker(unsigned seed, bool all_keyed) : random_(seed), all_keyed_(all_keyed) {
        keys_.resize(3 + below(10));
        wiring_.resize(keys_.size());
        for (auto& wiring : wiring_) wiring = static_cast<unsigned>(random_());
    }

    Frame next() {
        if (chance(2)) keys_[below(keys_.size())] = below(3);
        if (chance(10)) wiring_[below(keys_.size())] = static_cast<unsigned>(random_());
        if (chance(6)) retained_ = !retained_ || all_keyed_;
        Frame frame;
        frame.imports = {
            {"video", 1000, {.contents = 5 + below(2)}},
            {"window", 2000 + static_cast<std::uint32_t>(below(8) / 7), {.contents = {}, .retained = retained_}}};
        std::vector<std::string> readable{"video"}, writable{"video", "window"};
        for (std::size_t i = 0; i < keys_.size(); ++i) {
            if (chance(12)) continue;
            add_pass(frame, i, readable, writable);
        }
        for (const auto& name : readable) {
            if (name != "video" && chance(4)) frame.required.push_back(name);
        }
        return frame;
    }

    std::size_t below(std::size_t count) { return random_() % count; }
    bool chance(std::size_t one_in) { return below(one_in) == 0; }

private:
    void add_pass(Frame& frame, std::size_t index, std::vector<std::string>& readable,
                  std::vector<std::string>& writable) {
        std::mt19937 wires(wiring_[index]);
        PassSpec pass;
        pass.name = fmt::format("pass{}", index);
        pass.side_effect = wires() % 6 == 0;
        if (all_keyed_ || wires() % 5 != 0) pass.key = keys_[index];
        if (!pass.key) pass.noise = random_();
        pass.desc.width = wires() % 2 ? 64 : 32;
        std::set<std::string> written;
        for (auto i = wires() % 3; i > 0; --i) written.insert(writable[wires() % writable.size()]);
        std::set<std::string> read;
        for (auto i = wires() % 4; i > 0; --i) read.insert(readable[wires() % readable.size()]);
        for (const auto& name : written) read.erase(name);
        pass.writes.assign(written.begin(), written.end());
        pass.reads.assign(read.begin(), read.end());
        for (auto i = wires() % 3; i > 0; --i) pass.creates.push_back(fmt::format("t{}_{}", index, i));
        for (const auto& name : pass.creates) {
            readable.push_back(name);
            writable.push_back(name);
        }
        if (written.contains("window") && std::find(readable.begin(), readable.end(), "window") == readable.end()) {
            readable.push_back("window");
        }
        frame.passes.push_back(std::move(pass));
    }

    std::mt19937 random_;
    bool all_keyed_;
    bool retained_ = true;
    std::vector<std::uint64_t> keys_;
    std::vector<unsigned> wiring_;
};

std::string run_frame(TestBench& bench, const Frame& frame, const std::string& failing = {}) {
    bench.begin();
    for (const Import& import : frame.imports) bench.import(import.name, import.id, import.options);
    for (PassSpec pass : frame.passes) {
        if (pass.name == failing) {
            pass.also = [](PassContext&) { throw Error("told to fail"); };
        }
        bench.pass(std::move(pass));
    }
    for (const auto& name : frame.required) bench.require(name);
    return bench.run_only();
}

void expect_reference(TestBench& bench, const Frame& frame) {
    const Reference reference(frame);
    for (const auto& name : frame.required) EXPECT_EQ(bench.contents(name), reference.textures.at(name)) << name;
    for (const auto& [name, seen] : reference.effects) EXPECT_EQ(bench.effects.at(name), seen) << name;
}

class FrameGraphReuseRandom : public ::testing::TestWithParam<unsigned> {};

TEST_P(FrameGraphReuseRandom, WhatIsSeenIsWhatRunningEverythingGives) {
    for (unsigned seed = GetParam() * 100; seed < GetParam() * 100 + 40 && !HasFailure(); ++seed) {
        SCOPED_TRACE(seed);
        FrameMaker maker(seed, false);
        TestBench bench;
        for (int i = 0; i < 40 && !HasFailure(); ++i) {
            const Frame frame = maker.next();
            if (maker.chance(10) && !frame.passes.empty()) {
                try {
                    run_frame(bench, frame, frame.passes[maker.below(frame.passes.size())].name);
                } catch (const Error&) {
                    continue;
                }
            } else {
                run_frame(bench, frame);
            }
            expect_reference(bench, frame);
            if (HasFailure()) ADD_FAILURE() << "frame " << i << '\n' << bench.graph.describe();
        }
    }
}

TEST_P(FrameGraphReuseRandom, TheSameFrameAgainRunsNothing) {
    std::size_t reused = 0;
    for (unsigned seed = GetParam() * 100; seed < GetParam() * 100 + 10 && !HasFailure(); ++seed) {
        SCOPED_TRACE(seed);
        FrameMaker maker(seed, true);
        TestBench bench;
        for (int i = 0; i < 20 && !HasFailure(); ++i) {
            Frame frame = maker.next();
            // The video is restored by its owner, so a pass that writes on it can't be spared.
            for (PassSpec& pass : frame.passes) std::erase(pass.writes, "video");
            run_frame(bench, frame);
            const std::string again = run_frame(bench, frame);
            EXPECT_EQ(again.find(":run"), std::string::npos) << again;
            reused += again.find(":reused") != std::string::npos;
            expect_reference(bench, frame);
        }
    }
    EXPECT_GT(reused, 50u) << "most frames have something to reuse, or this test tests nothing";
}

INSTANTIATE_TEST_SUITE_P(Seeds, FrameGraphReuseRandom, ::testing::Range(0u, 5u));

} // namespace
} // namespace hachure::gpu::testing
