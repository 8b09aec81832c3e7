#pragma once

#include <stdexcept>

namespace hachure {

/// The command line asks for something that makes no sense; the program exits with 2.
class UsageError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

} // namespace hachure
