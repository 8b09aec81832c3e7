#include <hachure/runtime/app/log.h>
#include <hachure/runtime/error.h>

#include <cstdio>

namespace hachure {

namespace {

void print_line(const char* kind, std::string_view message) {
    // Error's text is one line whatever a file put into the message.
    std::fprintf(stderr, "hachure: %s: %s\n", kind, Error(message).what());
}

} // namespace

void log_warning(std::string_view message) { print_line("warning", message); }

void log_note(std::string_view message) { print_line("note", message); }

} // namespace hachure
