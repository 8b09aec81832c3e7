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

    /// The primitives of a mesh of a file, each a material of its own.
    explicit LineMesh(const assets::Mesh& mesh) : LineMesh(joined(mesh)) {
        for (std::size_t part = 0; part < mesh.primitives.size(); ++part)
            face_materials.insert(face_materials.end(), mesh.primitives[part].indices.size() / 3,
                                  static_cast<std::uint32_t>(part));
    }

    [[nodiscard]] static LineMesh read(const std::filesystem::path& file) {
        return LineMesh(assets::read_model(file).meshes.at(0));
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

private:
    [[nodiscard]] static Shape joined(const assets::Mesh& mesh) {
        Shape shape;
        for (const assets::Primitive& part : mesh.primitives) {
            const auto first = static_cast<std::uint32_t>(shape.positions.size());
            shape.positions.insert(shape.positions.end(), part.positions.begin(), part.positions.end());
            for (const std::uint32_t index : part.indices) shape.indices.push_back(first + index);
        }
        return shape;
    }
};

} // namespace hachure::geometry::reference
