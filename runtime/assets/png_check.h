#pragma once

#include <cstddef>
#include <span>
#include <string_view>

namespace hachure::assets {

/// Whether the bytes begin as every PNG file does.
[[nodiscard]] bool is_png(std::span<const std::byte> bytes);

/// Walks the chunks of a PNG file: lengths, order, end and checksums. Throws Error(name, fault, "byte 33"). Done before
/// decoding, since libpng prints its own line about a damaged file, which we could neither word nor suppress.
void check_png(std::string_view name, std::span<const std::byte> bytes);

} // namespace hachure::assets
