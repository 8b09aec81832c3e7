#pragma once

#include <chrono>
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

    /// `done` of `total` steps of the current stage are finished.
    void step(std::size_t done, std::size_t total);

private:
    void show(const std::string& line);

    std::chrono::steady_clock::time_point start_;
    std::string stage_;
    bool terminal_;
    bool shown_ = false;
};

} // namespace hachure
