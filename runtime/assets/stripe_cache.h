#pragma once

#include <hachure/runtime/assets/folder_cache.h>
#include <hachure/runtime/geometry/stripe_mesh.h>

#include <glm/vec3.hpp>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>

namespace hachure::assets {

inline constexpr std::uintmax_t stripe_cache_bytes = std::uintmax_t{512} << 20;

/// The stripe mesh of these arguments from `folder`/stripes, or from `geometry::make_stripe_mesh`, which is then kept
/// there. Files are named after a hash of the arguments and of the version of method and format, appear whole or not at
/// all, and are not trusted: one that is damaged or of other arguments counts as missing and is replaced. When all
/// together they are more than `limit` bytes, those used longest ago go. Without a folder, or with one that cannot be
/// used, the result is computed.
[[nodiscard]] geometry::StripeMesh
cached_stripe_mesh(std::span<const glm::vec3> positions, std::span<const glm::vec3> normals,
                   std::span<const std::uint32_t> indices, const geometry::StripeSettings& settings,
                   const std::optional<std::filesystem::path>& folder, std::uintmax_t limit = stripe_cache_bytes);

} // namespace hachure::assets
