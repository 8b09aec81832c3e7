#pragma once

#include <hachure/runtime/assets/model.h>
#include <hachure/runtime/assets/warning_list.h>

#include <filesystem>
#include <span>

/// What the readers of mesh files have in common: from polygons and attributes as a file has them to a valid Model.
namespace hachure::assets {

/// Cuts faces into triangles and counts what it had to repair.
class FaceCutter {
public:
    /// Appends the triangles of a face to `indices`. `corners` are vertices in range of `positions`.
    void add(std::span<const glm::vec3> positions, std::span<const std::uint32_t> corners,
             std::vector<std::uint32_t>& indices) {
        if (corners.size() == 3) {
            indices.insert(indices.end(), corners.begin(), corners.end());
            if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0]) ++repeated_;
        } else {
            add_polygon(positions, corners, indices);
        }
    }

    void report(WarningList& warnings) const;

private:
    void add_polygon(std::span<const glm::vec3> positions, std::span<const std::uint32_t> corners,
                     std::vector<std::uint32_t>& indices);

    std::size_t dropped_ = 0, repeated_ = 0, coarse_ = 0;
    std::vector<glm::vec3> points_; // scratch
    std::vector<std::uint32_t> polygon_, cut_;
};

/// A colour channel from sRGB to linear; negative and non-finite values give 0.
[[nodiscard]] float linear_from_srgb(float value);

/// Whether all three are finite.
[[nodiscard]] inline bool is_finite(const glm::vec3& v) {
    // Infinity and NaN are what times zero does not give zero.
    return v.x * 0.0f == 0.0f && v.y * 0.0f == 0.0f && v.z * 0.0f == 0.0f;
}

/// Makes normals unit, or drops them all (with a warning) when one has no direction; zeroes texture coordinates that
/// are not finite; makes colours linear.
void tidy_attributes(Primitive& primitive, WarningList& warnings);

/// Appends a mesh and a root node of the only scene that shows it.
void add_mesh(Model& model, std::string name, std::vector<Primitive> primitives);

/// A Model of one mesh, named after the file. Tidies it. Error: "no triangles".
[[nodiscard]] Model make_model(const std::filesystem::path& file, Primitive primitive, WarningList warnings);

/// The name of a file without folder and extensions.
[[nodiscard]] std::string model_name(const std::filesystem::path& file);

} // namespace hachure::assets
