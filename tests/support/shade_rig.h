#pragma once

#include <hachure/runtime/assets/read_model.h>
#include <hachure/runtime/geometry/shapes.h>
#include <hachure/systems/shade_strokes/shade_light.h>
#include <hachure/systems/shade_strokes/shade_update.h>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>
#include <vector>

namespace hachure::test {

inline ShadingLight shade_sun(const glm::vec3& towards, float strength = 1.0f) {
    return {.position = glm::vec4(glm::normalize(towards), 0.0f), .color = glm::vec3(strength)};
}

/// Needed against delivered shade, over the cells that can carry what they need.
struct ShadeError {
    double mean = 0.0, largest = 0.0;
    std::size_t unmet = 0; ///< cells that cannot
};

/// A mesh with the jobs that keep its strokes.
class ShadeRig {
public:
    explicit ShadeRig(geometry::Shape shape, std::uint32_t cells = 4000, ShadeSettings settings = {})
        : shape_(std::move(shape)),
          mesh_(make_shade_mesh(
              {.positions = shape_.positions, .normals = shape_.normals, .indices = shape_.indices, .cells = cells})),
          needed_(mesh_.cell_count(), 0.0f) {
        light.mesh = &mesh_;
        light.positions = shape_.positions;
        light.normals = shape_.normals;
        light.indices = shape_.indices;
        light.needed = needed_;
        update.mesh = &mesh_;
        update.settings = settings;
        update.needed = needed_;
        update.chains = &chains_;
    }
    ShadeRig(const ShadeRig&) = delete;
    ShadeRig& operator=(const ShadeRig&) = delete;

    void step(const std::vector<ShadingLight>& lights) {
        light.lights = lights;
        light.validate();
        light.run();
        light.lights = {};
        update.changed = light.swept;
        update.validate();
        update.run();
    }

    /// The sun from an angle around the Y axis, in degrees.
    void step_sun(double degrees) {
        const auto a = static_cast<float>(glm::radians(degrees));
        step({shade_sun({std::sin(a), 0.4f, std::cos(a)})});
    }

    [[nodiscard]] const geometry::Shape& shape() const { return shape_; }
    [[nodiscard]] const ShadeMesh& mesh() const { return mesh_; }
    [[nodiscard]] const ShadeChains& chains() const { return chains_; }
    [[nodiscard]] const std::vector<float>& needed() const { return needed_; }
    [[nodiscard]] std::vector<float> delivered() const {
        std::vector<float> result;
        for (const ShadeCellState& cell : chains_.cells) result.push_back(cell.delivered);
        return result;
    }
    [[nodiscard]] glm::dvec3 at(std::uint32_t node, std::size_t rib = 2) const {
        return mesh_.at(chains_.nodes[node].rib[rib]);
    }

    [[nodiscard]] ShadeError error() const {
        ShadeError result;
        std::size_t count = 0;
        for (std::size_t c = 0; c < needed_.size(); ++c) {
            if (chains_.cells[c].unmet >= 0.0f) {
                ++result.unmet;
                continue;
            }
            const double off = std::abs(double{needed_[c]} - chains_.cells[c].delivered);
            result.mean += off;
            result.largest = std::max(result.largest, off);
            ++count;
        }
        result.mean /= static_cast<double>(std::max<std::size_t>(1, count));
        return result;
    }

    /// The area that strokes cover times their alpha and the density, measured on the patches between ribs as they are
    /// drawn, over the area of the mesh: nothing of it comes from what the jobs account.
    [[nodiscard]] double ink() const {
        double sum = 0.0, area = 0.0;
        for (const ShadeSegment& segment : chains_.segments.all()) {
            if (segment.cell == no_slot) continue;
            for (std::size_t k = 0; k + 1 < rib_points; ++k) {
                const glm::dvec3 a = at(segment.from, k), b = at(segment.from, k + 1), c = at(segment.to, k + 1),
                                 d = at(segment.to, k);
                sum += segment.alpha * 0.5 * glm::length(glm::cross(c - a, d - b));
            }
        }
        for (const float cell : mesh_.cells.area) area += cell;
        return area > 0.0 ? sum * update.settings.density / area : 0.0;
    }

    ShadeLightJob light;
    ShadeUpdateJob update;

private:
    geometry::Shape shape_;
    ShadeMesh mesh_;
    std::vector<float> needed_;
    ShadeChains chains_;
};

/// All triangles of a model file as one shape.
inline geometry::Shape shape_of_file(const std::filesystem::path& file) {
    geometry::Shape shape;
    for (const assets::Mesh& mesh : assets::read_model(file).meshes) {
        for (const assets::Primitive& part : mesh.primitives) {
            const auto first = static_cast<std::uint32_t>(shape.positions.size());
            shape.positions.insert(shape.positions.end(), part.positions.begin(), part.positions.end());
            shape.normals.insert(shape.normals.end(), part.normals.begin(), part.normals.end());
            for (const std::uint32_t i : part.indices) shape.indices.push_back(first + i);
        }
    }
    return shape;
}

inline constexpr const char* bunny_file = "/usr/share/glmark2/models/bunny.obj";

} // namespace hachure::test
