#include <hachure/editor/play/make_expectation.h>
#include <hachure/editor/play/worst_frames.h>
#include <hachure/runtime/picture/flicker.h>
#include <hachure/runtime/picture/popping.h>

#include <fmt/format.h>

#include <algorithm>

namespace hachure::play {
namespace {

constexpr std::int64_t max_reach = 64; // pixels

/// No pixel changes more than that from a frame to the next.
class PoppingExpectation final : public Expectation {
public:
    PoppingExpectation(const ExpectationParts& parts) : Expectation("popping", parts.source.pointer, parts.frames) {
        JsonObject object(parts.source.text, parts.object.pointer("popping"), parts.object.at("popping"));
        if (object.has("at_most")) largest_ = object.number("at_most", 0.0, 255.0);
        if (object.has("p999_at_most")) p999_ = object.number("p999_at_most", 0.0, 255.0);
        if (!largest_ && !p999_) parts.object.fail("popping", "popping takes at_most, p999_at_most or both");
        meter_ = picture::PoppingMeter(static_cast<int>(object.integer("reach", 0, max_reach, 0)));
        object.finish();
        curves_ = {{"popping", "1/255", 0, {}, std::nullopt, largest_},
                   {"popping p99.9", "1/255", 0, {}, std::nullopt, p999_}};
    }

    [[nodiscard]] FrameNeed need() const override { return FrameNeed::drawn; }

    void look(PlayedFrame& frame) override {
        const std::optional<picture::Popping> change = meter_.add(frame.picture());
        worst_.add(frame.picture(), change ? change->largest : 0.0);
        if (!change) return;
        for (Curve& curve : curves_)
            if (curve.values.empty()) curve.first_frame = frame.number();
        curves_[0].values.push_back(change->largest);
        curves_[1].values.push_back(change->p999);
        if (largest_ && change->largest > *largest_)
            fail(frame.number(),
                 fmt::format("a pixel changes by {:.4g}/255, allowed are {:.4g}", change->largest, *largest_));
        if (p999_ && change->p999 > *p999_)
            fail(frame.number(), fmt::format("0.1 % of the pixels change by more than {:.4g}/255, allowed are {:.4g}",
                                             change->p999, *p999_));
    }

protected:
    [[nodiscard]] std::string what() const override {
        return largest_ ? fmt::format("no pixel changes by more than {}/255 at once", *largest_)
                        : fmt::format("0.1 % of the pixels change by no more than {}/255 at once", *p999_);
    }

    void judge(const JudgeContext& context, ExpectationResult& result) override {
        result.curves = curves_;
        result.frames = worst_.write(context.evidence, context.stem);
        if (curves_[0].values.empty()) return;
        result.reason =
            fmt::format("at most {:.4g}/255, p99.9 {:.4g}/255", *std::ranges::max_element(curves_[0].values),
                        *std::ranges::max_element(curves_[1].values));
    }

private:
    std::optional<double> largest_, p999_;
    picture::PoppingMeter meter_;
    WorstFrames worst_;
    std::vector<Curve> curves_;
};

/// Nothing is there, or missing, for one frame only.
class FlickerExpectation final : public Expectation {
public:
    FlickerExpectation(const ExpectationParts& parts) : Expectation("flicker", parts.source.pointer, parts.frames) {
        if (frames().last - frames().first < 2)
            parts.object.fail("frames", "flicker is seen over three frames or more");
        JsonObject object(parts.source.text, parts.object.pointer("flicker"), parts.object.at("flicker"));
        p99_ = object.number("at_most", 0.0, 1.0);
        if (object.has("mean_at_most")) mean_ = object.number("mean_at_most", 0.0, 1.0);
        if (object.has("largest_at_most")) largest_ = object.number("largest_at_most", 0.0, 1.0);
        meter_ = picture::FlickerMeter(static_cast<int>(object.integer("reach", 0, max_reach, 2)));
        object.finish();
        curve_ = {"flicker p99", "", 0, {}, std::nullopt, std::nullopt};
    }

    [[nodiscard]] FrameNeed need() const override { return FrameNeed::drawn; }

    void look(PlayedFrame& frame) override {
        const std::optional<double> now = meter_.add(frame.picture());
        worst_.add(frame.picture(), now.value_or(0.0));
        if (!now) return;
        if (curve_.values.empty()) curve_.first_frame = frame.number() - 1;
        curve_.values.push_back(*now);
    }

protected:
    [[nodiscard]] std::string what() const override { return fmt::format("flicker is at most {}", p99_); }

    void judge(const JudgeContext& context, ExpectationResult& result) override {
        const picture::Flicker flicker = meter_.result();
        result.curves = {curve_};
        result.frames = worst_.write(context.evidence, context.stem);
        result.reason =
            fmt::format("flicker p99 {:.4g}, mean {:.4g}, largest {:.4g}", flicker.p99, flicker.mean, flicker.largest);
        if (flicker.p99 > p99_ || (mean_ && flicker.mean > *mean_) || (largest_ && flicker.largest > *largest_))
            fail(worst_frame(), result.reason);
    }

private:
    [[nodiscard]] std::int64_t worst_frame() const {
        return curve_.first_frame + (std::ranges::max_element(curve_.values) - curve_.values.begin());
    }

    double p99_ = 0.0;
    std::optional<double> mean_, largest_;
    picture::FlickerMeter meter_;
    WorstFrames worst_;
    Curve curve_;
};

} // namespace

std::unique_ptr<Expectation> make_popping_expectation(const ExpectationParts& parts) {
    return std::make_unique<PoppingExpectation>(parts);
}

std::unique_ptr<Expectation> make_flicker_expectation(const ExpectationParts& parts) {
    return std::make_unique<FlickerExpectation>(parts);
}

} // namespace hachure::play
