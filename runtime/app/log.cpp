#include <hachure/runtime/app/log.h>
#include <hachure/runtime/error.h>

#include <cstdio>

namespace hachure {

void log_warning(std::string_view message) {
    // Error's text is one line whatever a file put into the message.
    std::fprintf(stderr, "hachure: warning: %s\n", Error(message).what());
}

} // namespace hachure
