#pragma once

#include <string_view>

namespace hachure {

/// One line on stderr: "hachure: warning: ...". For what was repaired or skipped; faults are exceptions.
void log_warning(std::string_view message);

/// One line on stderr: "hachure: note: ...". For what the user asked to be told, as scripts do.
void log_note(std::string_view message);

} // namespace hachure
