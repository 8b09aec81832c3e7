#pragma once

#include <hachure/runtime/geometry/vertex_neighbours.h>

#include <glm/vec3.hpp>

#include <complex>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace hachure::geometry {

/// A smooth field of principal directions on a mesh that deforms, every frame: where CurvatureJob is sure of its
/// directions they stay, and between them, at umbilics and on flat parts, each is the mean of those around it, as lines
/// without a sign, carried over the edges. Where a whole piece of the surface has none, the field is the default of
/// `direction_field`, whose energy this relaxes by a number of sweeps instead of solving it: a field that follows a
/// change of the mesh, in time that a frame has. It starts from nothing each time, so that frames do not depend on
/// those before them. Rounding of the positions moves it by as little. Allocates nothing after the first run on a mesh
/// of that size; results do not depend on the number of threads.
struct FillDirectionsJob {
    std::span<const glm::vec3> normals{};         ///< as CurvatureJob took them
    std::span<const std::uint32_t> weld{};        ///< likewise
    const VertexNeighbours* neighbours = nullptr; ///< of the mesh; required
    std::span<const glm::vec3> directions{};      ///< as CurvatureJob gives them
    std::span<const float> confidences{};         ///< likewise: in [0, 1]; 0.95 or more keeps the direction
    std::uint32_t sweeps = 32;                    ///< how many edges far neighbours are averaged, about

    std::span<glm::vec3> filled{}; ///< out: unit tangents of either sign, one per vertex; may be `directions`

    /// Asserts that sizes agree.
    void validate() const;
    void run();

    // Scratch, kept from run to run. A line is the complex number whose angle is twice that of its two directions, in
    // the frame of its vertex.
    using Line = std::complex<float>;
    std::vector<Line> wanted{}, otherwise{}, lines{}, next{};
    std::vector<Line> turns{}; ///< per entry of `neighbours`: from the neighbour's frame
    std::vector<std::uint32_t> open{}, front{}, beyond{};
    std::vector<std::uint8_t> reached{};

private:
    void read_vertex(std::uint32_t vertex);
    void reach_open_parts();
    void relax();
    [[nodiscard]] Line around(std::uint32_t vertex) const;
    [[nodiscard]] Line turn(std::uint32_t from, std::uint32_t to) const;
};

} // namespace hachure::geometry
