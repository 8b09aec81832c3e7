#pragma once

#include <hachure/runtime/assets/warning_list.h>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace hachure::assets {

/// A corner of a face: positions in the lists of ObjData. Not yet checked against their sizes, since a file may name
/// what follows later.
struct ObjCorner {
    static constexpr std::uint32_t absent = 0xffffffffu;
    std::uint32_t v, t, n;
    bool operator==(const ObjCorner&) const = default;
};

struct ObjFace {
    std::uint32_t first_corner; ///< up to the next face's
    std::uint32_t offset;       ///< in the file, for faults
};

/// Faces from `first_face` to that of the next run have this object and material.
struct ObjRun {
    std::uint32_t first_face;
    std::uint32_t object;  ///< into ObjData::objects
    std::int32_t material; ///< into ObjData::materials, -1 before the first usemtl
};

/// The statements of an OBJ file.
struct ObjData {
    std::vector<glm::vec3> positions; ///< finite
    std::vector<glm::vec3> colors;    ///< empty or one per position
    std::vector<glm::vec2> texcoords;
    std::vector<glm::vec3> normals;
    std::vector<ObjCorner> corners;
    std::vector<ObjFace> faces;
    std::vector<ObjRun> runs; ///< by rising first_face, which starts at 0
    std::vector<std::string> objects;
    std::vector<std::string> materials; ///< names in the order of their first use
    std::vector<std::string> libraries;
};

/// More objects or materials than this are folded into the last one: a hostile file must not cost a mesh per face.
inline constexpr std::size_t max_obj_parts = 65536;

[[nodiscard]] ObjData parse_obj(const std::filesystem::path& file, std::string_view text, WarningList& warnings);

} // namespace hachure::assets
