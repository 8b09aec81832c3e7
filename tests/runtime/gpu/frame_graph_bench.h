#pragma once

#include <hachure/runtime/gpu/frame_graph.h>
#include <hachure/runtime/gpu/frame_graph_null.h>

#include <gtest/gtest.h>

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace hachure::gpu::testing {

inline constexpr TextureDesc small{.width = 64, .height = 32, .format = Format::rgba8};

/// A pass in one line: what it uses, by name. When it runs, it hashes its name, key and inputs into each output.
struct PassSpec {
    std::string name;
    std::vector<std::string> creates{};
    std::vector<std::string> reads{};
    std::vector<std::string> writes{};
    std::optional<std::uint64_t> key{}; ///< nothing: the pass runs whenever it is needed
    bool side_effect = false;
    std::uint64_t noise = 0; ///< what an unkeyed pass also depends on, unknown to the graph
    TextureDesc desc = small;
    std::function<void(PassContext&)> also{}; ///< called when it runs, before it writes
};

/// A graph on the null back end, driven by names.
class TestBench {
public:
    NullBackend backend;
    FrameGraph graph{backend};
    std::map<std::string, TextureHandle> newest;
    std::map<std::string, std::uint64_t> effects; ///< what each pass with a side effect saw when it last ran

    TestBench() { begin(); }

    void begin() {
        newest.clear();
        undefined_.clear();
        graph.begin_frame();
    }

    /// Does what the owner of such a texture does: restores its contents, or loses them in a swap of buffers.
    void import(const std::string& name, std::uint32_t id, ImportOptions options = {}) {
        newest[name] = graph.import_texture(name, small, id, options);
        if (options.contents) backend.contents(id) = *options.contents;
        if (!options.retained) backend.contents(id) = ++garbage_;
        if (!options.contents) undefined_.insert(name);
    }

    void pass(PassSpec spec) {
        graph.add_pass<Uses>(
            spec.name, [&](PassBuilder& pass, Uses& uses) { setup(spec, pass, uses); },
            [this, spec](const Uses& uses, PassContext& context) { execute(spec, uses, context); });
    }

    void require(const std::string& name) { graph.require(newest.at(name)); }

    /// Runs the frame, begins the next one, and says what became of the passes, as in "gooch:run lines:culled".
    std::string run() {
        std::string states = run_only();
        begin();
        return states;
    }

    std::string run_only() {
        graph.run();
        std::string states;
        for (const PassStats& stats : graph.stats()) {
            states += (states.empty() ? "" : " ") + stats.name + ":" + std::string(to_string(stats.state));
        }
        return states;
    }

    [[nodiscard]] std::uint64_t contents(const std::string& name) {
        return backend.contents(graph.texture(newest.at(name)));
    }

    /// What a pass makes of its inputs, in the order of reads and then writes.
    static std::uint64_t result(const PassSpec& spec, const std::vector<std::uint64_t>& inputs,
                                const std::string& output) {
        std::size_t hash = std::hash<std::string>{}(spec.name + '>' + output);
        const auto mix = [&](std::uint64_t value) { hash = (hash ^ value) * 1099511628211u + (hash >> 29); };
        mix(spec.key.value_or(0));
        mix(spec.noise);
        for (const std::uint64_t input : inputs) mix(input);
        return hash;
    }

private:
    struct Uses {
        std::vector<TextureHandle> created, read, written;
        std::vector<bool> covered; ///< [i]: written[i] held nothing defined before, so the pass covers all of it
    };

    void setup(const PassSpec& spec, PassBuilder& pass, Uses& uses) {
        for (const auto& name : spec.reads) uses.read.push_back(pass.read(newest[name]));
        for (const auto& name : spec.writes) {
            uses.covered.push_back(undefined_.contains(name) && newest[name].version() == 0);
            uses.written.push_back(newest[name] = pass.write(newest[name]));
        }
        for (const auto& name : spec.creates) {
            uses.created.push_back(newest[name] = pass.create(name, spec.desc));
        }
        if (spec.key) pass.depends_on(*spec.key);
        if (spec.side_effect) pass.side_effect();
    }

    /// Ids from 1000 on are the tests' imported ones, which have no shape here.
    void expect_shape(const PassContext& context, TextureHandle handle) {
        const std::uint32_t id = context.texture(handle);
        if (id >= 1000) return;
        ASSERT_TRUE(backend.desc(id));
        EXPECT_EQ(*backend.desc(id), context.desc(handle));
    }

    void execute(const PassSpec& spec, const Uses& uses, PassContext& context) {
        if (spec.also) spec.also(context);
        for (const auto* handles : {&uses.created, &uses.read, &uses.written}) {
            for (const auto handle : *handles) expect_shape(context, handle);
        }
        std::vector<std::uint64_t> inputs;
        for (const auto handle : uses.read) inputs.push_back(backend.contents(context.texture(handle)));
        for (std::size_t i = 0; i < uses.written.size(); ++i) {
            inputs.push_back(uses.covered[i] ? 0 : backend.contents(context.texture(uses.written[i])));
        }
        if (spec.side_effect) effects[spec.name] = result(spec, inputs, "effect");
        for (std::size_t i = 0; i < uses.written.size(); ++i) {
            backend.contents(context.texture(uses.written[i])) = result(spec, inputs, spec.writes[i]);
        }
        for (std::size_t i = 0; i < uses.created.size(); ++i) {
            backend.contents(context.texture(uses.created[i])) = result(spec, inputs, spec.creates[i]);
        }
    }

    std::set<std::string> undefined_; // imported without contents
    std::uint64_t garbage_ = 0x6a00000000000000u;
};

/// A frame of two passes, "a" and "b", which reads what "a" creates, with these keys; says what was done with each.
inline std::string chain_frame(TestBench& bench, std::optional<std::uint64_t> ka, std::optional<std::uint64_t> kb) {
    bench.pass({.name = "a", .creates = {"x"}, .key = ka});
    bench.pass({.name = "b", .creates = {"y"}, .reads = {"x"}, .key = kb});
    bench.require("y");
    return bench.run();
}

} // namespace hachure::gpu::testing
