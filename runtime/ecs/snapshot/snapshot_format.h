#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

/// The frame of a snapshot; docs/snapshots.md describes it all.
namespace hachure::detail {

inline constexpr std::array<char, 8> snapshot_magic{'h', 'a', 'c', 'h', 's', 'n', 'a', 'p'};
inline constexpr std::uint32_t snapshot_version = 1;

/// Magic, version, length of the whole.
inline constexpr std::size_t snapshot_head_bytes = 8 + 4 + 8;
inline constexpr std::size_t snapshot_checksum_bytes = 4;

/// Each has a 64-bit length after it; they come in this order, `component` once per type.
enum class SnapshotSection : std::uint32_t { entities = 1, tree = 2, component = 3 };

/// More types than this no snapshot has.
inline constexpr std::uint32_t max_snapshot_types = 4096;

} // namespace hachure::detail
