#pragma once

#include <hachure/runtime/geometry/stripe_mesh.h>

#include <glm/vec3.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace hachure::assets {

/// A hash of everything that a stripe mesh follows from, 128 bits, and of the version of method and format.
using StripeKey = std::array<std::uint64_t, 2>;

[[nodiscard]] StripeKey stripe_key(std::span<const glm::vec3> positions, std::span<const glm::vec3> normals,
                                   std::span<const std::uint32_t> indices, const geometry::StripeSettings& settings);

/// 32 hexadecimal digits and ".stripes".
[[nodiscard]] std::string stripe_file_name(const StripeKey& key);

/// A stripe mesh as bytes: "HACHSTRP", the key, the numbers of vertices and indices, a hash of the rest, and the
/// arrays, in the machine's byte order.
[[nodiscard]] std::vector<std::byte> stripe_file_bytes(const StripeKey& key, const geometry::StripeMesh& mesh);

/// How many bytes that is at most for an input of this size.
[[nodiscard]] std::uintmax_t most_stripe_file_bytes(std::size_t vertices, std::size_t indices);

/// The mesh in such bytes, none when anything about them is wrong: another key, size or hash, an index out of range, a
/// vertex that is not where the input's triangles are, a number that is not finite.
[[nodiscard]] std::optional<geometry::StripeMesh> read_stripe_file(std::span<const std::byte> bytes,
                                                                   const StripeKey& key, std::size_t vertices,
                                                                   std::span<const std::uint32_t> indices);

} // namespace hachure::assets
