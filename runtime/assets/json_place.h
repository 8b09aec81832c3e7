#pragma once

#include <cstddef>
#include <string>
#include <string_view>

/// Where things stand in the text of a JSON document. The text need not be whole or right: what is odd is skipped.
namespace hachure::assets {

/// Line and column of a byte, both from 1. Columns count characters (a tab is one); lines end with LF or CRLF.
[[nodiscard]] std::string line_and_column(std::string_view text, std::size_t offset);

/// The byte at which the value of a JSON pointer begins, or the nearest value around it where there is none.
[[nodiscard]] std::size_t offset_of(std::string_view text, std::string_view pointer);

/// The byte at which `key` stands for the second time among those of the object that begins at `offset`; `offset` when
/// it does not.
[[nodiscard]] std::size_t offset_of_second_key(std::string_view text, std::size_t offset, std::string_view key);

/// A key as a JSON pointer has it (RFC 6901).
[[nodiscard]] std::string pointer_token(std::string_view key);

} // namespace hachure::assets
