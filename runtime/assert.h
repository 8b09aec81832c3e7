#pragma once

namespace hachure::detail {
[[noreturn]] void assertion_failed(const char* condition, const char* message, const char* file, int line);
} // namespace hachure::detail

/// Checks for our own mistakes, in every build: a broken promise inside the engine prints condition, message, file and
/// line, and aborts. Never used on what a file or a user said; that is `hachure::Error`.
#define HACHURE_ASSERT(condition, message)                                                                             \
    (static_cast<bool>(condition) ? static_cast<void>(0)                                                               \
                                  : ::hachure::detail::assertion_failed(#condition, message, __FILE__, __LINE__))
