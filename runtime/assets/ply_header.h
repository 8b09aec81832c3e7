#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace hachure::assets {

enum class PlyFormat : std::uint8_t { ascii, little_endian, big_endian };
enum class PlyType : std::uint8_t { i8, u8, i16, u16, i32, u32, f32, f64 };

/// Bytes of one value in a binary file.
[[nodiscard]] std::size_t ply_size(PlyType type);

struct PlyProperty {
    std::string name;
    PlyType type = PlyType::f32;      ///< of the value, or of the elements of a list
    PlyType count_type = PlyType::u8; ///< of a list
    bool is_list = false;
};

struct PlyElement {
    std::string name;
    std::uint64_t count = 0;
    std::vector<PlyProperty> properties;
};

struct PlyHeader {
    PlyFormat format = PlyFormat::ascii;
    std::vector<PlyElement> elements;
    std::size_t body = 0; ///< where in the file the values start
};

/// Reads the header and checks that the file is large enough for the counts that it claims.
[[nodiscard]] PlyHeader parse_ply_header(const std::filesystem::path& file, std::string_view text);

} // namespace hachure::assets
