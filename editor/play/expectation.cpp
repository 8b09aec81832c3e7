#include <hachure/editor/play/expectation.h>

#include <fmt/format.h>

namespace hachure::play {

void Expectation::fail(std::int64_t frame, const std::string& reason) {
    if (failures_++ > 0) return;
    failed_frame_ = frame;
    first_failure_ = frames_.first == frames_.last ? reason : fmt::format("frame {}: {}", frame, reason);
}

ExpectationResult Expectation::unjudged(std::string reason) const {
    ExpectationResult result;
    result.kind = kind_;
    result.pointer = pointer_;
    result.first_frame = frames_.first;
    result.last_frame = frames_.last;
    result.what = what();
    if (need() != FrameNeed::nothing)
        result.what = (frames_.first == frames_.last ? fmt::format("frame {}", frames_.first)
                                                     : fmt::format("frames {} to {}", frames_.first, frames_.last)) +
                      ": " + result.what;
    result.reason = std::move(reason);
    return result;
}

ExpectationResult Expectation::result(const JudgeContext& context) {
    ExpectationResult result = unjudged({});
    if (need() != FrameNeed::nothing && frames_.last < context.from) {
        result.passed = true;
        result.reason = fmt::format("not looked at: it lies before frame {}", context.from);
        return result;
    }
    judge(context, result);
    result.passed = failures_ == 0;
    if (result.passed) return result;
    result.reason = first_failure_;
    if (failures_ > 1) result.reason += fmt::format(" (and {} more)", failures_ - 1);
    return result;
}

} // namespace hachure::play
