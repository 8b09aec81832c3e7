#pragma once

#include <string>
#include <unordered_set>

namespace hachure {

/// Says each warning one time, since what is amiss in one frame mostly is in the next.
class WarnOnce {
public:
    /// See log_warning. False when it was said before.
    bool say(const std::string& warning);

private:
    std::unordered_set<std::string> said_;
};

} // namespace hachure
