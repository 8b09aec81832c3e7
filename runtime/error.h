#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

namespace hachure {

/// What is wrong with a file, the system or the driver. Programs print `what()` on one line after `hachure: error: `
/// and exit with 1; nothing has been written when it is thrown.
class Error : public std::runtime_error {
public:
    /// A fault that has no file (a missing context, a refused setting).
    explicit Error(std::string_view fault);

    /// A fault of `subject` (a path, or another name a user can act on). `where` says where in it: a byte offset, a
    /// line, a JSON pointer; empty when the fault is the whole file's. Control characters are replaced by '?', so the
    /// message stays one line whatever a file contains.
    Error(std::string_view subject, std::string_view fault, std::string_view where = {});
};

} // namespace hachure
