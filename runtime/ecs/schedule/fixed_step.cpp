#include <hachure/runtime/assert.h>
#include <hachure/runtime/ecs/schedule/fixed_step.h>

#include <algorithm>
#include <cmath>

namespace hachure::detail {
namespace {

/// Beyond it, a double no longer tells steps apart.
constexpr double most_steps = 9007199254740992.0; // 2^53

/// How many steps fit into `elapsed`. Products are compared, as quotients round: n frames of one step are n steps.
std::uint64_t steps_in(double elapsed, double step) {
    const double quotient = std::floor(elapsed / step);
    HACHURE_ASSERT(quotient < most_steps, "the time elapsed can be counted in steps");
    double steps = quotient;
    while (steps > 0 && steps * step > elapsed) --steps;
    while ((steps + 1) * step <= elapsed) ++steps;
    return static_cast<std::uint64_t>(steps);
}

} // namespace

FixedStep::FixedStep(double seconds, int max_steps) : seconds_(seconds), max_steps_(max_steps) {
    HACHURE_ASSERT(std::isfinite(seconds) && seconds > 0, "a step takes time");
    HACHURE_ASSERT(max_steps >= 1, "a frame has room for a step");
}

int FixedStep::advance(double delta) {
    HACHURE_ASSERT(std::isfinite(delta) && delta >= 0, "time goes forward");
    // Elapsed time is kept in two doubles, so that the error of a sum over hours of frames is that of one rounding.
    const double added = delta + remainder_;
    const double sum = elapsed_ + added;
    const double part = sum - elapsed_;
    remainder_ = (elapsed_ - (sum - part)) + (added - part);
    elapsed_ = sum;

    const std::uint64_t due = steps_in(elapsed_, seconds_) - taken_ - dropped_;
    const std::uint64_t now = std::min(due, static_cast<std::uint64_t>(max_steps_));
    taken_ += now;
    dropped_ += due - now;
    return static_cast<int>(now);
}

double FixedStep::fraction() const {
    const double since = elapsed_ - static_cast<double>(taken_ + dropped_) * seconds_ + remainder_;
    return std::clamp(since / seconds_, 0.0, std::nextafter(1.0, 0.0));
}

} // namespace hachure::detail
