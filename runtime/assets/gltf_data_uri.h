#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

namespace hachure::assets {

[[nodiscard]] inline bool is_data_uri(std::string_view uri) {
    return uri.starts_with("data:") || uri.starts_with("DATA:");
}

/// The bytes of a base64 data URI (`data:[type];base64,...`, RFC 2397); nullopt when it is not one or the base64 is
/// broken. Missing padding is accepted.
[[nodiscard]] std::optional<std::vector<std::byte>> decode_data_uri(std::string_view uri);

} // namespace hachure::assets
