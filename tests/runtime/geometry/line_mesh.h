#pragma once

#include <hachure/runtime/assets/read_model.h>
#include <hachure/runtime/geometry/curvature.h>
#include <hachure/runtime/geometry/curvature_derivative.h>
#include <hachure/runtime/geometry/edges.h>
#include <hachure/runtime/geometry/normals.h>
#include <hachure/runtime/geometry/shapes.h>
#include <hachure/runtime/geometry/weld.h>

#include <filesystem>
#include <vector>

namespace hachure::geometry::reference {

/// A mesh with what lines on it are found from.
struct LineMesh {
    std::vector<glm::vec3> positions, normals, directions;
    std::vector<std::uint32_t> indices, weld, face_materials;
    std::vector<glm::vec2> curvatures;
    std::vector<glm::vec4> derivatives, planes;
    EdgeTable table;

    LineMesh(std::vector<glm::vec3> p, std::vector<std::uint32_t> i, bool with_curvature = false)
        : positions(std::move(p)), normals(positions.size()), indices(std::move(i)), weld(weld_positions(positions)),
          planes(indices.size() / 3), table(build_edge_table(positions, indices)) {
        face_planes(positions, indices, planes);
        SmoothNormalsJob job{.positions = positions, .indices = indices, .weld = weld, .normals = normals};
        job.run();
        if (with_curvature) find_curvature();
    }
    explicit LineMesh(const Shape& shape, bool with_curvature = false)
        : LineMesh(shape.positions, shape.indices, with_curvature) {}

    /// All primitives of a file, each a material of its own.
    static LineMesh read(const std::filesystem::path& file) {
        std::vector<glm::vec3> p;
        std::vector<std::uint32_t> i, materials;
        for (const assets::Mesh& mesh : assets::read_model(file).meshes)
            for (const assets::Primitive& part : mesh.primitives) {
                const auto first = static_cast<std::uint32_t>(p.size());
                p.insert(p.end(), part.positions.begin(), part.positions.end());
                for (const std::uint32_t index : part.indices) i.push_back(first + index);
                const std::uint32_t material = materials.empty() ? 0u : materials.back() + 1;
                materials.insert(materials.end(), part.indices.size() / 3, material);
            }
        LineMesh result(std::move(p), std::move(i));
        result.face_materials = std::move(materials);
        return result;
    }

    void find_curvature() {
        curvatures.resize(positions.size());
        directions.resize(positions.size());
        derivatives.resize(positions.size());
        CurvatureJob curvature{.positions = positions,
                               .normals = normals,
                               .indices = indices,
                               .weld = weld,
                               .curvatures = curvatures,
                               .directions = directions};
        curvature.run();
        CurvatureDerivativeJob derivative = derivative_job();
        derivative.validate();
        derivative.run();
    }

    [[nodiscard]] CurvatureDerivativeJob derivative_job() {
        return {.positions = positions,
                .normals = normals,
                .indices = indices,
                .weld = weld,
                .curvatures = curvatures,
                .directions = directions,
                .derivatives = derivatives};
    }
};

} // namespace hachure::geometry::reference
