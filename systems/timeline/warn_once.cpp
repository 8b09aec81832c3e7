#include <hachure/runtime/app/log.h>
#include <hachure/systems/timeline/warn_once.h>

namespace hachure {

bool WarnOnce::say(const std::string& warning) {
    // Names can be made up without end, memory can't.
    constexpr std::size_t most = 10'000;
    if (said_.size() >= most || !said_.insert(warning).second) return false;
    log_warning(warning);
    return true;
}

} // namespace hachure
