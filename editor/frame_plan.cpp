#include <hachure/editor/frame_plan.h>
#include <hachure/editor/usage_error.h>
#include <hachure/runtime/assert.h>

#include <charconv>
#include <string_view>

namespace hachure {
namespace {

constexpr std::int64_t max_frame = 9'999'999;
constexpr std::int64_t max_frames = 1'000'000; // nine hours
constexpr double max_time = 1e7;               // seconds, that of the last frame at the slowest rate

std::optional<std::int64_t> parse_number(std::string_view text) {
    if (text.empty() || text.find_first_not_of("0123456789") != text.npos) return {};
    std::int64_t number = 0;
    const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), number);
    return fault == std::errc{} && number <= max_frame ? std::optional(number) : std::nullopt;
}

void parse_frames(const std::string& text, FramePlan& plan) {
    const std::string_view view(text);
    const std::size_t dots = view.find("..");
    const auto first = parse_number(view.substr(0, dots));
    const auto last = dots == view.npos ? first : parse_number(view.substr(dots + 2));
    if (!first || !last)
        throw UsageError("--frames: '" + text + "' is not A..B with whole numbers from 0 to " +
                         std::to_string(max_frame));
    if (*first > *last) throw UsageError("--frames: '" + text + "' ends before it begins");
    plan.first = *first;
    plan.last = *last;
    plan.numbered = true;
    if (plan.count() > max_frames) throw UsageError("--frames: at most " + std::to_string(max_frames) + " at once");
}

double parse_time(const std::string& text) {
    double seconds = 0;
    const char* end = text.data() + text.size();
    const auto [stop, fault] = std::from_chars(text.data(), end, seconds);
    if (fault != std::errc{} || stop != end || !(seconds >= 0 && seconds <= max_time))
        throw UsageError("--time: '" + text + "' is not a number of seconds from 0 to 10000000");
    return seconds;
}

} // namespace

FramePlan parse_frame_plan(const std::string& frames, const std::string& time, const std::string& fps) {
    HACHURE_ASSERT(frames.empty() || time.empty(), "--frames and --time exclude each other");
    FramePlan plan;
    const std::optional<assets::FrameRate> rate = assets::parse_frame_rate(fps);
    if (!rate)
        throw UsageError("--fps: '" + fps + "' is not a rate from 1 to " + std::to_string(assets::max_frame_rate) +
                         ", such as 25, 29.97 or 30000/1001");
    plan.rate = *rate;
    if (!frames.empty()) parse_frames(frames, plan);
    if (!time.empty()) plan.time = parse_time(time);
    return plan;
}

} // namespace hachure
