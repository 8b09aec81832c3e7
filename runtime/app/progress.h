#pragma once

#include <chrono>
#include <cstddef>
#include <string>
#include <string_view>

namespace hachure {

/// What a long command is doing, on one line of a terminal that is rewritten in place and cleared at the end. Nothing
/// is shown when stderr is no terminal, nor before half a second has passed.
class Progress {
public:
    explicit Progress(std::string_view stage);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// Names what happens now.
    void stage(std::string_view text);

    /// `done` of `total` steps of the current stage are finished. Once there are some, the line also says how long the
    /// others will take if they go on like that. Called for every step: the line changes a few times a second.
    void step(std::size_t done, std::size_t total);

private:
    using Clock = std::chrono::steady_clock;

    void show(const std::string& line);

    Clock::time_point start_, stage_start_, shown_at_;
    std::string stage_;
    bool terminal_;
    bool shown_ = false;
};

/// What `Progress` says when `done` of `total` steps took `seconds`: "drawing 30/120, 0:09 left".
[[nodiscard]] std::string progress_line(std::string_view stage, std::size_t done, std::size_t total, double seconds);

} // namespace hachure
