#pragma once

#include <hachure/editor/frame_plan.h>

#include <cstdint>
#include <optional>
#include <string>

namespace hachure {

/// One of several runs that draw a sequence together.
struct FrameShare {
    std::int64_t index = 1; ///< from 1 to count
    std::int64_t count = 1;
};

/// From the text of `--chunk`: "I/N". Throws UsageError.
[[nodiscard]] FrameShare parse_frame_share(const std::string& text);

/// The frames of the plan that are the share's: shares follow each other and differ by one frame at most. Nothing where
/// there are fewer frames than shares and this one has none.
[[nodiscard]] std::optional<FramePlan> share_of(const FramePlan& plan, FrameShare share);

} // namespace hachure
