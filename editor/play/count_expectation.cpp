#include <hachure/editor/frame_stats.h>
#include <hachure/editor/play/make_expectation.h>

#include <fmt/format.h>

#include <algorithm>

namespace hachure::play {
namespace {

/// So many entities carry a component, or one of the counts of `--stats` is so high.
class CountExpectation final : public Expectation {
public:
    CountExpectation(const ExpectationParts& parts)
        : Expectation("count", parts.source.pointer, parts.frames), name_(parts.object.text("count")),
          type_(parts.source.types.find(name_)), limits_(parse_limits(parts.object)) {
        if (!type_ && !std::ranges::count(frame_count_names(), name_)) {
            std::string names;
            for (const std::string_view name : frame_count_names())
                names += (names.empty() ? "" : ", ") + std::string(name);
            parts.object.fail("count", "'" + name_ + "' is neither a component nor one of " + names);
        }
        const bool bounded = limits_.at_least || limits_.at_most;
        if (parts.object.has("is") == bounded)
            parts.source.text.fail(parts.source.pointer, "a count takes either is, or at_least and at_most");
        if (!bounded) {
            constexpr std::int64_t most = std::int64_t{1} << 53;
            limits_.at_least = limits_.at_most = static_cast<double>(parts.object.integer("is", 0, most));
        }
        curve_ = {name_, "", 0, {}, limits_.at_least, limits_.at_most};
    }

    [[nodiscard]] FrameNeed need() const override { return FrameNeed::logic; }

    void look(PlayedFrame& frame) override {
        const double count = type_ ? static_cast<double>(type_->entities(frame.world()).size())
                                   : static_cast<double>(frame_counts(frame.world()).at(name_));
        if (curve_.values.empty()) curve_.first_frame = frame.number();
        curve_.values.push_back(count);
        if (limits_.at_least && count < *limits_.at_least)
            fail(frame.number(),
                 fmt::format("there are {}, not {}{}", count, is_exact() ? "" : "at least ", *limits_.at_least));
        if (limits_.at_most && count > *limits_.at_most)
            fail(frame.number(),
                 fmt::format("there are {}, not {}{}", count, is_exact() ? "" : "at most ", *limits_.at_most));
    }

protected:
    [[nodiscard]] std::string what() const override {
        if (is_exact()) return fmt::format("{} of {}", *limits_.at_least, name_);
        std::string result;
        if (limits_.at_least) result = fmt::format("at least {}", *limits_.at_least);
        if (limits_.at_most) result += fmt::format("{}at most {}", result.empty() ? "" : " and ", *limits_.at_most);
        return result + " of " + name_;
    }

    void judge(const JudgeContext&, ExpectationResult& result) override { result.curves = {curve_}; }

private:
    [[nodiscard]] bool is_exact() const { return limits_.at_least == limits_.at_most; }

    std::string name_;
    const TypeInfo* type_;
    Limits limits_;
    Curve curve_;
};

} // namespace

std::unique_ptr<Expectation> make_count_expectation(const ExpectationParts& parts) {
    return std::make_unique<CountExpectation>(parts);
}

} // namespace hachure::play
