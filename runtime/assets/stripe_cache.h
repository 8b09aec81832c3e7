#pragma once

#include <hachure/runtime/geometry/stripe_mesh.h>

#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <vector>

namespace hachure::assets {

/// Where results are kept between runs of the program: what HACHURE_CACHE names, or else hachure in $XDG_CACHE_HOME, or
/// else ~/.cache/hachure. None when HACHURE_CACHE is "off" or no home is known. The folder need not exist.
[[nodiscard]] std::optional<std::filesystem::path> user_cache_folder();

/// The stripe mesh of these arguments from `folder/stripes`, or from `geometry::make_stripe_mesh`, which is then kept
/// there. Files are named after a hash of the arguments and of the version of their format, appear whole or not at
/// all, and are not trusted: one that is damaged or of other arguments counts as missing and is replaced. When they
/// are more than `limit` bytes together, those used longest ago go. Never throws because of the cache: where the
/// folder cannot be used, the result is computed.
[[nodiscard]] geometry::StripeMesh cached_stripe_mesh(std::span<const glm::vec3> positions,
                                                      std::span<const glm::vec3> normals,
                                                      std::span<const std::uint32_t> indices,
                                                      const geometry::StripeSettings& settings,
                                                      const std::optional<std::filesystem::path>& folder,
                                                      std::uintmax_t limit = std::uintmax_t{512} << 20);

} // namespace hachure::assets
