#include <hachure/editor/frame_share.h>
#include <hachure/editor/usage_error.h>

#include <charconv>

namespace hachure {
namespace {

constexpr std::int64_t max_shares = 1'000'000; // as many as a sequence has frames

} // namespace

FrameShare parse_frame_share(const std::string& text) {
    FrameShare share;
    const char* end = text.data() + text.size();
    const auto index = std::from_chars(text.data(), end, share.index);
    const bool slash = index.ec == std::errc{} && index.ptr != end && *index.ptr == '/';
    const auto count = slash ? std::from_chars(index.ptr + 1, end, share.count) : index;
    if (!slash || count.ec != std::errc{} || count.ptr != end || share.index < 1 || share.count < share.index ||
        share.count > max_shares)
        throw UsageError("--chunk: '" + text + "' is not I/N with 1 <= I <= N <= " + std::to_string(max_shares));
    return share;
}

std::optional<FramePlan> share_of(const FramePlan& plan, FrameShare share) {
    FramePlan part = plan;
    part.first = plan.first + plan.count() * (share.index - 1) / share.count;
    part.last = plan.first + plan.count() * share.index / share.count - 1;
    if (part.first > part.last) return {};
    return part;
}

} // namespace hachure
