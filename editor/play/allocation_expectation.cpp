#include <hachure/editor/play/make_expectation.h>

#include <fmt/format.h>

namespace hachure::play {
namespace {

/// The systems before stage render allocate memory at most so often in a frame.
class AllocationExpectation final : public Expectation {
public:
    AllocationExpectation(const ExpectationParts& parts)
        : Expectation("allocations", parts.source.pointer, parts.frames),
          at_most_(static_cast<std::uint64_t>(parts.object.integer("allocations", 0, INT64_MAX))) {
        curve_ = {"allocations", "", 0, {}, std::nullopt, static_cast<double>(at_most_)};
    }

    [[nodiscard]] FrameNeed need() const override { return FrameNeed::logic; }
    [[nodiscard]] bool counts_allocations() const override { return true; }

    void look(PlayedFrame& frame) override {
        const std::optional<std::uint64_t> count = frame.allocations();
        if (!count) return fail(frame.number(), "this program does not count allocations");
        if (curve_.values.empty()) curve_.first_frame = frame.number();
        curve_.values.push_back(static_cast<double>(*count));
        if (*count > at_most_) fail(frame.number(), fmt::format("the systems allocate memory {} times", *count));
    }

protected:
    [[nodiscard]] std::string what() const override { return fmt::format("at most {} allocations a frame", at_most_); }
    void judge(const JudgeContext&, ExpectationResult& result) override { result.curves = {curve_}; }

private:
    std::uint64_t at_most_;
    Curve curve_;
};

} // namespace

std::unique_ptr<Expectation> make_allocation_expectation(const ExpectationParts& parts) {
    return std::make_unique<AllocationExpectation>(parts);
}

} // namespace hachure::play
