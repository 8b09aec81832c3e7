#include <hachure/editor/play/make_expectation.h>
#include <hachure/runtime/assert.h>

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace hachure::play {
namespace {

constexpr int rounds = 3; // in turn, the best of each counts: others use the machine, too

/// A frame, or opening the scene, takes at most so many times what it takes with other settings.
class TimeExpectation final : public Expectation {
public:
    TimeExpectation(const ExpectationParts& parts) : Expectation("time", parts.source.pointer, parts.frames) {
        JsonObject object(parts.source.text, parts.object.pointer("time"), parts.object.at("time"));
        const std::string of = object.text("of", "frame");
        if (of != "frame" && of != "load") object.fail("of", "'" + of + "' is neither frame nor load");
        of_ = of == "load" ? TimeOf::load : TimeOf::frame;
        at_most_ = object.number("at_most", 0.0, std::numeric_limits<double>::max());
        JsonObject rival(parts.source.text, object.pointer("relative_to"), object.at("relative_to"));
        sets_ = rival.texts("set");
        if (sets_.empty())
            rival.document().fail(rival.pointer(), "relative_to takes set, which says what is different");
        for (std::size_t i = 0; i < sets_.size(); ++i)
            check_assignment(parts.source.types, sets_[i], parts.source.text, child_pointer(rival.pointer("set"), i));
        rival.finish();
        object.finish();
    }

    [[nodiscard]] FrameNeed need() const override { return FrameNeed::nothing; }
    void look(PlayedFrame&) override { HACHURE_ASSERT(false, "it looks at no frame"); }

protected:
    [[nodiscard]] std::string what() const override {
        std::string sets;
        for (const std::string& set : sets_) sets += (sets.empty() ? "" : ", ") + set;
        return fmt::format("{} takes at most {} times what it takes with {}",
                           of_ == TimeOf::load ? "opening it" : "a frame", at_most_, sets);
    }

    void judge(const JudgeContext& context, ExpectationResult& result) override {
        double own = std::numeric_limits<double>::max(), rival = own;
        for (int i = 0; i < rounds; ++i) {
            own = std::min(own, context.measure(of_, {}));
            rival = std::min(rival, context.measure(of_, sets_));
        }
        result.reason = fmt::format("{:.3g} times: {:.3g} ms against {:.3g} ms", own / rival, 1e3 * own, 1e3 * rival);
        if (!(own <= at_most_ * rival)) fail(0, result.reason);
    }

private:
    TimeOf of_ = TimeOf::frame;
    double at_most_ = 0.0;
    std::vector<std::string> sets_;
};

} // namespace

std::unique_ptr<Expectation> make_time_expectation(const ExpectationParts& parts) {
    return std::make_unique<TimeExpectation>(parts);
}

} // namespace hachure::play
