#include <hachure/editor/play/make_expectation.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>

namespace hachure::play {
namespace {

std::string list_of(const std::set<std::string>& names) {
    std::string result;
    for (const std::string& name : names) result += (result.empty() ? "" : ", ") + name;
    return result.empty() ? "none" : result;
}

/// A pass runs, is reused, is culled, or is not there at all.
class PassExpectation final : public Expectation {
public:
    PassExpectation(const ExpectationParts& parts)
        : Expectation("pass", parts.source.pointer, parts.frames), pass_(parts.object.text("pass")),
          state_(parts.object.text("state")) {
        constexpr std::array<const char*, 4> states{"run", "reused", "culled", "absent"};
        if (!std::ranges::count(states, state_))
            parts.object.fail("state", "'" + state_ + "' is none of run, reused, culled, absent");
    }

    [[nodiscard]] FrameNeed need() const override { return FrameNeed::drawn_twice; }

    void look(PlayedFrame& frame) override {
        std::string state = "absent";
        for (const gpu::PassStats& pass : frame.renderer().pass_stats())
            if (pass.name == pass_) state = gpu::to_string(pass.state);
        if (state != state_) fail(frame.number(), "it is " + state);
    }

protected:
    [[nodiscard]] std::string what() const override { return "pass " + pass_ + " is " + state_; }
    void judge(const JudgeContext&, ExpectationResult&) override {}

private:
    std::string pass_, state_;
};

/// These passes run, and no others.
class PassesExpectation final : public Expectation {
public:
    PassesExpectation(const ExpectationParts& parts) : Expectation("passes", parts.source.pointer, parts.frames) {
        const std::vector<std::string> names = parts.object.texts("passes");
        wanted_.insert(names.begin(), names.end());
    }

    [[nodiscard]] FrameNeed need() const override { return FrameNeed::drawn_twice; }

    void look(PlayedFrame& frame) override {
        std::set<std::string> run, more, fewer;
        for (const gpu::PassStats& pass : frame.renderer().pass_stats())
            if (pass.state == gpu::PassState::run) run.insert(pass.name);
        std::ranges::set_difference(run, wanted_, std::inserter(more, more.end()));
        std::ranges::set_difference(wanted_, run, std::inserter(fewer, fewer.end()));
        if (!more.empty()) fail(frame.number(), "these run, too: " + list_of(more));
        if (!fewer.empty()) fail(frame.number(), "these do not run: " + list_of(fewer));
    }

protected:
    [[nodiscard]] std::string what() const override { return "the passes that run are " + list_of(wanted_); }
    void judge(const JudgeContext&, ExpectationResult&) override {}

private:
    std::set<std::string> wanted_;
};

} // namespace

std::unique_ptr<Expectation> make_pass_expectation(const ExpectationParts& parts) {
    return std::make_unique<PassExpectation>(parts);
}

std::unique_ptr<Expectation> make_passes_expectation(const ExpectationParts& parts) {
    return std::make_unique<PassesExpectation>(parts);
}

} // namespace hachure::play
